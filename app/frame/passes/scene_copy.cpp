// Copies what is behind a layer of glass: colour, as level 0 of the scene-colour pyramid, and depth, which refracted rays intersect.
#include "frame/passes/passes.h"

#include <algorithm>

namespace gg::frame {
namespace {

// The narrowest level is this many pixels across its shorter side: for a blur as wide as the picture.
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

// Whether glass that forms images is drawn before the layer and none of it touches a body of the layer: bodies in contact do not see
// each other as images.
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

std::vector<Input> SceneCopy::inputs() const {
  std::vector<Input> inputs{{"screenPyramid", pyramid, gpu::Filter::linear}};
  if (depth) inputs.push_back({"sceneCopyDepth", *depth});
  if (hiding_depth) inputs.push_back({"hidingDepth", *hiding_depth});
  return inputs;
}

// Depth is that of opaque surfaces (the colour behind flat glass is that of what rays meet behind it) until a layer has glass before
// it that forms images.
SceneCopy declare_scene_copy(Graph& graph, const needs::Needs& needs, std::size_t layer) {
  const bool blurs = frame_blurs(needs);
  SceneCopy scene_copy{
      .pyramid = {graph.target(
          {.name = "screen pyramid",
           .format = color_format,
           .levels = blurs ? pyramid_levels(needs.view.width, needs.view.height) : 1})},
      .blurs = needs.layers[layer].blurs};
  const auto depth_target = [&](const char* name) {
    return Part{graph.target({.name = name, .format = gpu::Format::r32f})};
  };
  Pass pass{.label = "scene copy",
            .reads = {{"sceneColor", {scene_color(graph)}}},
            .colors = {{.part = {scene_copy.pyramid.target, 0}}}};
  bool takes_depth = false;
  if (blurs) {
    scene_copy.depth = scene_copy.hiding_depth = depth_target("scene copy depth");
    takes_depth = !graph.is_written(scene_copy.depth->target) || sees_images(needs, layer);
  }
  // A second copy serves both.
  if (!takes_depth && needs.layers[layer].interleaves)
    scene_copy.hiding_depth = depth_target("glass depth");
  const bool copies_depth = takes_depth || scene_copy.hiding_depth != scene_copy.depth;
  if (copies_depth) {
    pass.reads.push_back({"sceneDepth", {scene_depth(graph)}});
    pass.colors.push_back({.part = *scene_copy.hiding_depth});
  }
  pass.prepare = [copies_depth](Context& context) -> Record {
    gpu::PipelineDesc desc{.label = "scene copy",
                           .fragment = "scene_copy.frag",
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
  return scene_copy;
}

} // namespace gg::frame
