// What a frame keeps on the device, and what for.
#include "frame/declare.h"
#include "frame/regions.h"
#include "uniforms/blocks.h"

#include <algorithm>

namespace gg::frame {
namespace {

template <class T>
std::size_t padded(std::size_t count) {
  return (sizeof(T) + gpu::block_alignment - 1) / gpu::block_alignment * gpu::block_alignment
         * std::max<std::size_t>(count, 1);
}

} // namespace

std::vector<Share> memory_of(const needs::Needs& needs, const Graph& graph) {
  const scene::Scene& scene = *needs.scene;
  std::size_t vertices = 0, indices = 0, tables = 0, textures = 0;
  for (const scene::Index i : needs.streams)
    vertices += needs.stream(i).values.size() * sizeof(float);
  for (const scene::Index i : needs.index_lists)
    indices += scene.indices[static_cast<std::size_t>(i)].size() * sizeof(std::uint32_t);
  for (const needs::Table& table : needs.tables)
    tables += table.bytes;
  for (const needs::Image& image : needs.images)
    textures += needs::bytes_of(image);
  const std::size_t regions = region_blocks(needs).size();
  const auto surrounded = static_cast<std::size_t>(std::ranges::count_if(
      needs.draws.all, [](const needs::Draw& draw) { return !draw.neighbours.empty(); }));
  const std::size_t uniforms =
      padded<uniforms::FrameData>(static_cast<std::size_t>(needs.view.samples))
      + padded<uniforms::MaterialData>(needs.draws.materials.size())
      + padded<uniforms::InstanceData>(needs.draws.instances.size())
      + padded<uniforms::RegionData>(regions)
      + (surrounded > 0 ? padded<uniforms::NeighboursData>(surrounded) : 0)
      + (needs.shadows.views.empty() ? 0
                                     : padded<uniforms::FrameData>(needs.shadows.views.size())
                                           + padded<uniforms::ShadowsData>(1))
      + std::max<std::size_t>(scene.lights.size(), 1) * sizeof(uniforms::LightData);
  return {{"environment", needs.view.environment.value_or(0)},
          {"tables", tables},
          {"textures", textures},
          {"vertices", vertices},
          {"indices", indices},
          {"uniforms", uniforms},
          {"targets", allocate(graph).bytes}};
}

std::size_t bytes_of(const std::vector<Share>& memory) {
  std::size_t sum = 0;
  for (const Share& share : memory)
    sum += share.bytes;
  return sum;
}

} // namespace gg::frame
