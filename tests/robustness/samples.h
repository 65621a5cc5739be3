// Sound files of every kind that the program reads, to be damaged.
#pragma once

#include "image/image.h"
#include "scene/gltf_file.h"

#include <cstddef>
#include <vector>

namespace gg::test {

using Bytes = std::vector<std::byte>;

// Everything that geometry can be stored as, in one file: plain, meshopt, Draco, sparse, a strip, a skin, a morph target; with
// textures, a preset in extras, a camera and a light.
GltfFile rich();
// A square with this picture (of this MIME type) on it.
GltfFile textured(const Bytes& picture, const char* mime_type);

image::Image sample(int width, int height);
// The sample as image::write encodes it: ".hdr", ".exr", ".pfm" or ".png". Leaves the file in the scratch directory.
Bytes written(const char* extension);
Bytes jpeg(bool progressive);
Bytes webp(bool lossless);
// UASTC by Zstandard, with levels.
Bytes ktx2();

} // namespace gg::test
