// Depth-peeled front and back faces of solids (Wyman 2005), one after another, in which the search for the exit of a refracted
// ray reads (shaders/refraction/interior_fetch.glsl).
#include "frame/passes/passes.h"

#include <array>
#include <string>

namespace gg::frame {
namespace {

constexpr gpu::Format texel_format = gpu::Format::rgba32ui;
constexpr std::uint32_t peels = 53; // constant of stages/interior.frag

constexpr std::array<const char*, 4> faces = {"F1", "B1", "F2", "B2"};

std::vector<const needs::Draw*> solids_of(const needs::Layer& layer, int part) {
  std::vector<const needs::Draw*> solids;
  for (const needs::Draw* solid : layer.solids)
    if (part < 2 * value_of(solid->key, needs::Feature::interior_pairs)) solids.push_back(solid);
  return solids;
}

} // namespace

std::size_t declare_faces(Graph& graph, const std::vector<const needs::Draw*>& solids, int part,
                          int pairs) {
  const bool peeling = part > 1;
  const std::size_t interior = graph.target(
      {.name = "interior", .format = texel_format, .layers = 2 * pairs, .array = true});
  const std::size_t depth = graph.target({.name = "interior depth", .format = depth_format});
  const auto prepare = [=](Context& context) -> Record {
    const DrawPass pass{.label = peeling ? "interior behind" : "interior",
                        .fragment = "interior.frag",
                        .colors = {texel_format},
                        .constants = {gpu::constant(peels, peeling)}};
    Records records;
    for (const needs::Draw* solid : solids)
      records.push_back(context.draws.recorded(
          pass, {solid, part % 2 == 0 ? needs::Faces::front : needs::Faces::back}));
    return [&context, records](gpu::Encoder& encoder) { context.draws.record(encoder, records); };
  };
  Pass pass{.label = std::string("interior ") + faces[static_cast<std::size_t>(part)],
            .draws = solids.size(),
            .shades = true,
            .colors = {{.part = {interior, 0, part}, .clear = {{0, 0, 0, 0}}}},
            .depth = DepthOutput{depth, 0.0f},
            .prepare = prepare};
  if (peeling) pass.reads = {{"nearer", {interior, 0, part - 2}}};
  graph.passes.push_back(std::move(pass));
  return interior;
}

std::optional<Input> declare_interior(Graph& graph, const needs::Needs& needs, std::size_t l) {
  const needs::Layer& layer = needs.layers[l];
  int pairs = 0; // in the array, for whichever layer wants most
  for (const needs::Layer& other : needs.layers)
    pairs = std::max(pairs, other.interior_pairs);
  std::optional<Input> input;
  for (int part = 0; part < 2 * layer.interior_pairs; ++part)
    input = Input{"interior", {declare_faces(graph, solids_of(layer, part), part, pairs)}};
  return input;
}

} // namespace gg::frame
