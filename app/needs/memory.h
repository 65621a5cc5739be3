// The images and buffers of a scene that its frame uploads.
#pragma once

#include "needs/draws.h"

#include <cstddef>
#include <string>
#include <vector>

namespace gg::needs {

// An image of the file as materials read it.
struct Image {
  scene::Index image = scene::none;
  bool srgb = false, mipmaps = false;
  int width = 0, height = 0;
};

int mip_levels(int width, int height); // of a complete chain
std::size_t bytes_of(const Image& image);

// Each once: images in the order of first use, the others by index.
std::vector<Image> images_of(const scene::Scene& scene, const std::vector<const Draw*>& draws);
std::vector<scene::Index> streams_of(const std::vector<const Draw*>& draws);
std::vector<scene::Index> index_lists_of(const std::vector<const Draw*>& draws);

} // namespace gg::needs
