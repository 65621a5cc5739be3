#include "needs/memory.h"

#include <algorithm>
#include <bit>

namespace gg::needs {
namespace {

std::size_t texels(int width, int height, int levels) {
  std::size_t count = 0;
  for (int level = 0; level < levels; ++level)
    count += static_cast<std::size_t>(std::max(width >> level, 1))
             * static_cast<std::size_t>(std::max(height >> level, 1));
  return count;
}

std::vector<scene::Index> each_once(std::vector<scene::Index> list) {
  std::ranges::sort(list);
  const auto rest = std::ranges::unique(list);
  list.erase(rest.begin(), rest.end());
  return list;
}

} // namespace

int mip_levels(int width, int height) {
  return std::bit_width(static_cast<unsigned>(std::max(width, height)));
}

std::size_t bytes_of(const Image& image) {
  constexpr std::size_t rgba8 = 4;
  return rgba8
         * texels(image.width, image.height,
                  image.mipmaps ? mip_levels(image.width, image.height) : 1);
}

std::vector<Image> images_of(const scene::Scene& scene, const std::vector<const Draw*>& draws) {
  std::vector<Image> images;
  for (const Draw* draw : draws)
    for (const Map& map : draw->maps) {
      const scene::Texture& texture = scene.textures[static_cast<std::size_t>(map.texture)];
      auto found = std::ranges::find_if(images, [&](const Image& image) {
        return image.image == texture.image && image.srgb == map.srgb;
      });
      if (found == images.end()) {
        const image::Image8& file = *scene.images[static_cast<std::size_t>(texture.image)];
        found = images.insert(
            found,
            {.image = texture.image, .srgb = map.srgb, .width = file.width, .height = file.height});
      }
      found->mipmaps = found->mipmaps || texture.sampler.mipmaps;
    }
  return images;
}

std::vector<scene::Index> streams_of(const std::vector<const Draw*>& draws) {
  std::vector<scene::Index> streams;
  for (const Draw* draw : draws)
    for (const VertexInput& input : draw->inputs)
      streams.push_back(input.stream);
  return each_once(std::move(streams));
}

std::vector<scene::Index> index_lists_of(const std::vector<const Draw*>& draws) {
  std::vector<scene::Index> lists;
  for (const Draw* draw : draws)
    lists.push_back(draw->primitive->indices);
  return each_once(std::move(lists));
}

} // namespace gg::needs
