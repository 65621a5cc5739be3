#include "frame/regions.h"

#include <limits>

namespace gg::frame {
namespace {

// Of a depth in floats: four products and sums make a clip coordinate, and a division the depth.
constexpr double depth_rounding = 8.0 * std::numeric_limits<float>::epsilon();

// The depth by which the n-th region finds its pixels: exact in floats, and never 0, which is where there is none.
double material_depth(std::size_t n) {
  return static_cast<double>(n + 1) * static_cast<double>(uniforms::REGION_STEP);
}

// As shaders/stages/object.glsl says it.
int solid_number(const needs::Draw& draw) {
  return static_cast<int>(draw.instance_index * 4096 + static_cast<std::size_t>(draw.body) % 4096
                          + 1);
}

// Samples lie up to half a pixel off.
uniforms::RegionData block_of(const needs::ScreenBox& box, const needs::View& view, double depth,
                              int step = 1, int number = 0) {
  const double margin = step == 1 ? 1.0 : 2.0 * step; // the picture may end within a fragment
  const glm::dvec2 pixel(2.0 * margin / view.width, 2.0 * margin / view.height);
  return {glm::vec4(box.low - pixel, box.high + pixel), glm::vec4(depth, step, number, 0.0)};
}

// The same place in a target of corners, whose last ones lie beyond the picture.
uniforms::RegionData at_corners(uniforms::RegionData block, const needs::View& view) {
  const auto share = [](int pixels) {
    return static_cast<float>(pixels)
           / static_cast<float>(uniforms::CELL_STEP * corners_of(pixels));
  };
  const float x = share(view.width), y = share(view.height);
  const auto moved = [&](float left, float top) {
    return glm::vec2((left + 1.0f) * x - 1.0f, 1.0f - (1.0f - top) * y);
  };
  // A corner stands for pixels beside it.
  const glm::vec2 margin(4.0f / static_cast<float>(corners_of(view.width)),
                         4.0f / static_cast<float>(corners_of(view.height)));
  block.box =
      glm::vec4(moved(block.box.x, block.box.y) - margin, moved(block.box.z, block.box.w) + margin);
  return block;
}

void add_opaque(std::vector<uniforms::RegionData>& blocks, const needs::Needs& needs) {
  const std::vector<needs::Region>& regions = needs.opaque_regions;
  const auto block = [&](std::size_t region, std::size_t number) {
    return block_of(regions[region].box, needs.view, material_depth(number));
  };
  if (regions.empty()) return;
  needs::ScreenBox box = regions.front().box;
  for (const needs::Region& region : regions)
    grow(box, region.box);
  const uniforms::RegionData all =
      block_of(box, needs.view, 0.0, 1, static_cast<int>(regions.size()));
  for (std::size_t i = 0; i < regions.size(); ++i)
    blocks.push_back(block(i, i));
  blocks.push_back(all);
  for (std::size_t i = 0; i < regions.size(); ++i)
    blocks.push_back(block(i, regions.size() + i));
  for (std::size_t i = 0; i < regions.size(); ++i)
    blocks.push_back(at_corners(block(i, i), needs.view));
  blocks.push_back(at_corners(all, needs.view));
}

} // namespace

std::vector<uniforms::RegionData> region_blocks(const needs::Needs& needs) {
  std::vector<uniforms::RegionData> blocks;
  add_opaque(blocks, needs);
  // At a solid's far end: the depth test passes where something is nearer, which its front faces have just drawn.
  for (const needs::Layer& layer : needs.layers)
    for (const needs::Region& region : layer.regions)
      for (const int step : {1, glass_step})
        blocks.push_back(block_of(region.box, needs.view,
                                  region.box.farthest_depth * (1.0 - depth_rounding), step,
                                  solid_number(*region.draws.front())));
  return blocks;
}

std::size_t layer_region(const needs::Needs& needs, std::size_t layer, std::size_t region,
                         bool low_rate) {
  std::size_t at = needs.opaque_regions.empty() ? 0 : all_opaque_corners(needs) + 1;
  for (std::size_t l = 0; l < layer; ++l)
    at += 2 * needs.layers[l].regions.size();
  return at + 2 * region + (low_rate ? 1 : 0);
}

} // namespace gg::frame
