// The file formats behind image.h, one source file each. Bytes in, bytes out: only image.cpp
// touches the disk. `name` is the file's name for messages; every reader throws Error(input).
#pragma once

#include "image/image.h"
#include "image/size.h"

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace gg::image::formats {

using Bytes = std::span<const std::byte>;

enum class Format { unknown, hdr, exr, pfm, png, jpeg, webp, ktx2 };

// By the first bytes, not by the extension: files are renamed more often than they are converted.
Format recognise(Bytes bytes);

Image read_hdr(Bytes bytes, const std::string& name);
Image read_pfm(Bytes bytes, const std::string& name);
Exr read_exr(Bytes bytes, const std::string& name);
// The colour of an EXR: R, G, B (and A), or Y alone; of the unnamed layer or else of the only one. Straight from the file, which
// takes no more memory than the picture, or of all its channels.
Image read_exr_colour(Bytes bytes, const std::string& name);
Image colour_of(const Exr& exr, const std::string& name);

Image8 decode_png(Bytes bytes, const std::string& name);
Image8 decode_jpeg(Bytes bytes, const std::string& name);
Image8 decode_webp(Bytes bytes, const std::string& name);
// The largest level. Throws Error(unsupported) where there is no libktx.
Image8 decode_ktx2(Bytes bytes, const std::string& name);

// What these declare in their heads, accepted (check_size).
Size size_of_png(Bytes bytes, const std::string& name);
Size size_of_jpeg(Bytes bytes, const std::string& name);
Size size_of_webp(Bytes bytes, const std::string& name);
Size size_of_ktx2(Bytes bytes, const std::string& name);

std::vector<std::byte> encode_hdr(const Image& image);
std::vector<std::byte> encode_pfm(const Image& image);
std::vector<std::byte> encode_exr(const Exr& exr, const std::string& name);
std::vector<std::byte> encode_png(const Image& image, const std::string& name);
// Quality 95 of 100, full chroma resolution; a fourth channel is dropped.
std::vector<std::byte> encode_jpeg(const Image& image, const std::string& name);

// Throws Error(input) if a picture of this size is not accepted (max_side, max_pixels), before
// anything is allocated for it.
void check_size(const std::string& where, long long width, long long height);

} // namespace gg::image::formats
