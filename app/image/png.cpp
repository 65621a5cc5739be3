// PNG by libpng, which checks every checksum.
#include "core/error.h"
#include "image/formats.h"

#include <png.h>

#include <algorithm>
#include <cmath>
#include <csetjmp>
#include <cstring>

namespace gg::image::formats {
namespace {

// What libpng's callbacks share. libpng leaves by longjmp, so the functions that call setjmp keep
// nothing with a destructor: it lives here, in the caller's frame.
struct State {
  Bytes in;
  std::size_t at = 0;
  std::vector<std::byte> out;
  std::string message;
  png_structp png = nullptr;
  png_infop info = nullptr;
  std::vector<png_bytep> rows;
};

void on_error(png_structp png, png_const_charp message) {
  static_cast<State*>(png_get_error_ptr(png))->message = message;
  png_longjmp(png, 1);
}

void on_warning(png_structp, png_const_charp) {}

void read_bytes(png_structp png, png_bytep to, std::size_t count) {
  State& state = *static_cast<State*>(png_get_io_ptr(png));
  if (count > state.in.size() - state.at) png_error(png, "ends too soon");
  std::memcpy(to, state.in.data() + state.at, count);
  state.at += count;
}

void write_bytes(png_structp png, png_bytep from, std::size_t count) {
  State& state = *static_cast<State*>(png_get_io_ptr(png));
  const std::byte* const begin = reinterpret_cast<const std::byte*>(from);
  state.out.insert(state.out.end(), begin, begin + count);
}

void flush_bytes(png_structp) {}

struct Reader : State {
  ~Reader() { png_destroy_read_struct(&png, &info, nullptr); }

  bool read_header() {
    if (setjmp(png_jmpbuf(png))) return false;
    png_set_read_fn(png, static_cast<State*>(this), read_bytes);
    png_set_user_limits(png, static_cast<png_uint_32>(max_side),
                        static_cast<png_uint_32>(max_side));
    // Text, profiles and the like are not used, so what they unpack to is of no interest.
    png_set_chunk_malloc_max(png, 1 << 20);
    png_read_info(png, info);
    return true;
  }

  // Everything as 8-bit RGBA.
  bool read_pixels() {
    if (setjmp(png_jmpbuf(png))) return false;
    png_set_expand(png); // palettes, fewer than 8 bits, transparent colours
    png_set_scale_16(png);
    png_set_gray_to_rgb(png);
    png_set_add_alpha(png, 0xff, PNG_FILLER_AFTER);
    png_set_interlace_handling(png);
    png_read_update_info(png, info);
    png_read_image(png, rows.data());
    png_read_end(png, nullptr);
    return true;
  }
};

[[noreturn]] void fail(const State& state, const std::string& name) {
  throw Error(ExitCode::input, name + ", byte " + std::to_string(state.at),
              "is truncated or malformed: " + state.message, "Download or write the file again.");
}

// Deflate turns one byte into 1032 at the very most (258 bytes for two bits), so a file that
// declares more than that cannot be whole, and is refused before memory is taken for it.
void check_ratio(const Reader& reader, const std::string& name) {
  const std::uint64_t raw = std::uint64_t{png_get_rowbytes(reader.png, reader.info)}
                            * png_get_image_height(reader.png, reader.info);
  if (raw / 1032 <= reader.in.size()) return;
  throw Error(ExitCode::input, name,
              "declares " + std::to_string(png_get_image_width(reader.png, reader.info)) + " x "
                  + std::to_string(png_get_image_height(reader.png, reader.info))
                  + " pixels, which its " + std::to_string(reader.in.size()) + " bytes cannot hold",
              "Download or write the file again.");
}

// Reads the header.
Size open(Reader& reader, Bytes bytes, const std::string& name) {
  reader.in = bytes;
  reader.png = png_create_read_struct(PNG_LIBPNG_VER_STRING, static_cast<State*>(&reader), on_error,
                                      on_warning);
  reader.info = reader.png ? png_create_info_struct(reader.png) : nullptr;
  if (!reader.info) throw std::bad_alloc();
  if (!reader.read_header()) fail(reader, name);
  const png_uint_32 width = png_get_image_width(reader.png, reader.info);
  const png_uint_32 height = png_get_image_height(reader.png, reader.info);
  check_size(name, width, height);
  check_ratio(reader, name);
  return {static_cast<int>(width), static_cast<int>(height)};
}

struct Writer : State {
  ~Writer() { png_destroy_write_struct(&png, &info); }

  bool write(const Image& image) {
    if (setjmp(png_jmpbuf(png))) return false;
    png_set_write_fn(png, static_cast<State*>(this), write_bytes, flush_bytes);
    const int type = image.channels == 1   ? PNG_COLOR_TYPE_GRAY
                     : image.channels == 3 ? PNG_COLOR_TYPE_RGB
                                           : PNG_COLOR_TYPE_RGB_ALPHA;
    png_set_IHDR(png, info, static_cast<png_uint_32>(image.width),
                 static_cast<png_uint_32>(image.height), 8, type, PNG_INTERLACE_NONE,
                 PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    png_set_sRGB(png, info, PNG_sRGB_INTENT_PERCEPTUAL);
    png_write_info(png, info);
    png_write_image(png, rows.data());
    png_write_end(png, nullptr);
    return true;
  }
};

void set_rows(std::vector<png_bytep>& rows, std::uint8_t* pixels, int height, std::size_t pitch) {
  rows.resize(static_cast<std::size_t>(height));
  for (std::size_t y = 0; y < rows.size(); ++y)
    rows[y] = pixels + y * pitch;
}

} // namespace

Size size_of_png(Bytes bytes, const std::string& name) {
  Reader reader;
  return open(reader, bytes, name);
}

Image8 decode_png(Bytes bytes, const std::string& name) {
  Reader reader;
  const auto [width, height] = open(reader, bytes, name);
  Image8 image{.width = width, .height = height, .rgba = {}};
  const std::size_t pitch = std::size_t{4} * static_cast<std::size_t>(width);
  image.rgba.resize(pitch * static_cast<std::size_t>(height));
  set_rows(reader.rows, image.rgba.data(), height, pitch);
  if (!reader.read_pixels()) fail(reader, name);
  return image;
}

std::vector<std::byte> encode_png(const Image& image, const std::string& name) {
  std::vector<std::uint8_t> pixels(image.values.size());
  std::transform(image.values.begin(), image.values.end(), pixels.begin(), [](float v) {
    return static_cast<std::uint8_t>(std::lround(std::clamp(v, 0.0f, 1.0f) * 255.0f));
  });
  Writer writer;
  writer.png = png_create_write_struct(PNG_LIBPNG_VER_STRING, static_cast<State*>(&writer),
                                       on_error, on_warning);
  writer.info = writer.png ? png_create_info_struct(writer.png) : nullptr;
  if (!writer.info) throw std::bad_alloc();
  set_rows(writer.rows, pixels.data(), image.height,
           static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.channels));
  if (!writer.write(image))
    throw Error(ExitCode::output, name, "could not be encoded: " + writer.message);
  return std::move(writer.out);
}

} // namespace gg::image::formats
