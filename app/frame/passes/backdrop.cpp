// The picture behind a layer of glass: level 0 of its scene-colour pyramid, and the depth of what refracted rays meet.
#include "frame/passes/passes.h"

#include <algorithm>

namespace gg::frame {
namespace {

// The narrowest level is this many pixels across its shorter side: it stands for a blur as wide as the picture.
constexpr int least_pyramid = 4;

int pyramid_levels(int width, int height) {
  int levels = 1;
  for (int size = std::min(width, height); size / 2 >= least_pyramid; size /= 2)
    ++levels;
  return levels;
}

// They overlap, and the first does not lie within the second.
bool touches(const scene::Bounds& a, const scene::Bounds& b) {
  const bool overlap =
      glm::all(glm::lessThan(a.low, b.high)) && glm::all(glm::lessThan(b.low, a.high));
  const bool within =
      glm::all(glm::greaterThan(a.low, b.low)) && glm::all(glm::lessThan(a.high, b.high));
  return overlap && !within;
}

// Whether glass that makes images is drawn before the layer, and none of it touches what is in the layer: of two bodies in
// contact the one is no picture that the other sees.
bool sees_images(const needs::Needs& needs, std::size_t layer) {
  bool any = false;
  for (std::size_t before = 0; before < layer; ++before)
    for (const needs::Draw* image : needs.layers[before].solids) {
      if (!image->images) continue;
      any = true;
      for (const needs::Draw* solid : needs.layers[layer].solids)
        if (touches(image->bounds, solid->bounds)) return false;
    }
  return any;
}

bool frame_blurs(const needs::Needs& needs) {
  return std::ranges::any_of(needs.layers, &needs::Layer::blurs);
}

} // namespace

std::vector<Input> Backdrop::inputs() const {
  std::vector<Input> inputs{{"screenPyramid", pyramid, gpu::Filter::linear}};
  if (depth) inputs.push_back({"backdropDepth", *depth});
  if (hiding_depth) inputs.push_back({"hidingDepth", *hiding_depth});
  return inputs;
}

// Depth is that of opaque surfaces (rays pass flat glass, and what they meet behind it shows its colour) until a layer has glass
// before it that makes images.
Backdrop declare_backdrop(Graph& graph, const needs::Needs& needs, std::size_t layer) {
  const bool blurs = frame_blurs(needs);
  Backdrop backdrop{
      .pyramid = {graph.target(
          {.name = "screen pyramid",
           .format = color_format,
           .levels = blurs ? pyramid_levels(needs.view.width, needs.view.height) : 1})},
      .blurs = needs.layers[layer].blurs};
  const auto depth_target = [&](const char* name) {
    return Part{graph.target({.name = name, .format = gpu::Format::r32f})};
  };
  Pass pass{.label = "backdrop",
            .reads = {{"sceneColor", {scene_color(graph)}}},
            .colors = {{.part = {backdrop.pyramid.target, 0}}}};
  bool takes_depth = false;
  if (blurs) {
    backdrop.depth = backdrop.hiding_depth = depth_target("backdrop depth");
    takes_depth = !graph.is_written(backdrop.depth->target) || sees_images(needs, layer);
  }
  // Taken again, the one holds the other.
  if (!takes_depth && needs.layers[layer].interleaves)
    backdrop.hiding_depth = depth_target("glass depth");
  const bool copies_depth = takes_depth || backdrop.hiding_depth != backdrop.depth;
  if (copies_depth) {
    pass.reads.push_back({"sceneDepth", {scene_depth(graph)}});
    pass.colors.push_back({.part = *backdrop.hiding_depth});
  }
  pass.prepare = [copies_depth](Context& context) -> Record {
    gpu::PipelineDesc desc{.label = "backdrop",
                           .fragment = "backdrop.frag",
                           .constants = {gpu::constant(0, copies_depth)},
                           .colors = {color_format}};
    if (copies_depth) desc.colors.push_back(gpu::Format::r32f);
    gpu::PipelineRef copy = context.fullscreen(desc);
    return [copy](gpu::Encoder& encoder) {
      encoder.use(copy);
      encoder.draw(3);
    };
  };
  graph.passes.push_back(std::move(pass));
  return backdrop;
}

} // namespace gg::frame
