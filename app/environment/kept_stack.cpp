#include "environment/kept_stack.h"

#include "core/error.h"
#include "core/kept.h"
#include "gpu/shader_files.h"

#include <span>
#include <vector>

namespace gg::environment {
namespace {

// 21 megabytes each for a map of 1024 x 512. The magic changes with the order of what is in the file.
constexpr Kept kept{.folder = "environments",
                    .extension = ".stack",
                    .magic = "ggstack1",
                    .most_files = 16,
                    .largest_file = std::size_t{1} << 30};
constexpr int least_height = 256; // of a map: smaller ones are prefiltered in a tenth of a second

// Every level of every cube, in the order of the file.
template <typename F>
void each_face(const Stack& stack, const F& f) {
  for (const gpu::TextureRef& cube : {stack.even, stack.odd, stack.irradiance})
    for (int level = 0; level < cube->desc.levels; ++level)
      for (int face = 0; face < 6; ++face) {
        const gpu::Extent size = gpu::extent(cube->desc, level);
        f(cube, level, face,
          static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height)
              * gpu::bytes_per_texel(cube->desc.format));
      }
}

} // namespace

std::optional<std::string> key_of_stack(const gpu::Device& device, const Map& map) {
  if (map.height < least_height || !kept.possible()) return std::nullopt;
  KeyHash hash;
  hash.add(program_identity());
  try {
    for (const char* stage :
         {"environment_equirect.comp", "environment_blur.comp", "environment_zonal.comp"})
      hash.add(gpu::shader_text_hash(stage));
  } catch (const Error&) {
    return std::nullopt; // which compiling it says better
  }
  const gpu::DeviceInfo& info = device.info();
  hash.add(info.backend + ' ' + info.name + ' ' + info.driver + ' ');
  hash.add(std::to_string(map.width) + 'x' + std::to_string(map.height) + ' ');
  hash.add(std::as_bytes(std::span(map.rgb)));
  return hash.text();
}

bool load_stack(gpu::Device& device, const std::string& key, const Stack& stack) {
  std::size_t bytes = 0;
  each_face(stack, [&](const gpu::TextureRef&, int, int, std::size_t size) { bytes += size; });
  const auto data = kept.load(key);
  if (!data || data->size() != bytes) return false;
  std::size_t at = 0;
  each_face(stack, [&](const gpu::TextureRef& cube, int level, int face, std::size_t size) {
    device.upload(cube, level, face, std::span(*data).subspan(at, size));
    at += size;
  });
  return true;
}

void store_stack(gpu::Device& device, const std::string& key, const Stack& stack) {
  std::vector<std::byte> data;
  each_face(stack, [&](const gpu::TextureRef& cube, int level, int face, std::size_t) {
    const std::vector<std::byte> texels = device.read(cube, level, face);
    data.insert(data.end(), texels.begin(), texels.end());
  });
  kept.store(key, data);
}

} // namespace gg::environment
