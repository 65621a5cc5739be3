#include "frame/declare.h"

#include "frame/passes/passes.h"

namespace gg::frame {

Graph graph_of(const needs::Needs& needs) {
  Graph graph{.width = needs.view.width, .height = needs.view.height};
  declare_shadows(graph, needs);
  declare_geometry(graph, needs);
  declare_opaque(graph, needs);
  const std::optional<NeighbourLight> neighbours = declare_neighbour_light(graph, needs);
  declare_material_depth(graph, needs, neighbours);
  declare_deferred(graph, needs, neighbours);
  declare_blended(graph, needs);
  for (std::size_t l = 0; l < needs.layers.size(); ++l) { // far to near
    std::optional<SceneCopy> scene_copy;
    if (needs.layers[l].shows_behind()) {
      scene_copy = declare_scene_copy(graph, needs, l);
      declare_foreground(graph, needs, l, *scene_copy);
      declare_pyramid(graph, *scene_copy);
    }
    const std::optional<Input> interior = declare_interior(graph, needs, l);
    declare_refractive(graph, needs, l, scene_copy, interior);
  }
  declare_accumulate(graph, needs);
  read_shadows(graph, needs);
  return graph;
}

} // namespace gg::frame
