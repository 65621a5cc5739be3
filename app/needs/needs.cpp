#include "needs/needs.h"

#include "needs/neighbours.h"
#include "needs/regions.h"

#include <algorithm>
#include <functional>

namespace gg::needs {
namespace {

// Each layer of glass behind glass takes a pyramid's time, not its memory. Past this many, surfaces share the last layer: they hide
// each other but do not show each other. Light through so many panes of common glass, .92 each, is below the rounding of floats of 32
// bits.
constexpr std::size_t most_layers = 256;

void sort_opaque(Needs& needs) {
  std::vector<const Draw*> draws;
  for (const Draw& draw : needs.draws.all)
    if (draw.role == Role::opaque) draws.push_back(&draw);
  std::ranges::stable_sort(draws, std::less{}, [](const Draw* draw) { return draw->distance; });
  const auto fine = std::ranges::stable_partition(draws, std::not_fn(&Draw::by_pixel));
  needs.opaque_regions = opaque_regions_of({fine.begin(), fine.end()}, needs.view);
  needs.opaque.assign(draws.begin(), fine.begin());
}

void sort_layers(Needs& needs) {
  for (Layer& layer :
       layers_of(*needs.scene, needs.draws, clip_from_world(needs.view), most_layers)) {
    // Blended surfaces over opaque ones alone need no pass of their own.
    if (needs.layers.empty() && !layer.shows_behind()) {
      needs.over_opaque.insert(needs.over_opaque.end(), layer.blended.begin(), layer.blended.end());
      continue;
    }
    // It is cut out of the blur, so it matters only where there is one.
    if (!layer.blurs) layer.foreground.clear();
    needs.layers.push_back(std::move(layer));
  }
}

// The scene's box is tight, those of the draws leave out what is not drawn.
scene::Bounds bounds_of(const std::vector<Draw>& draws, const scene::Bounds& scene) {
  scene::Bounds bounds;
  for (const Draw& draw : draws) {
    bounds.include(draw.bounds.low);
    bounds.include(draw.bounds.high);
  }
  bounds.low = glm::max(bounds.low, scene.low);
  bounds.high = glm::min(bounds.high, scene.high);
  return bounds;
}

// Gives draws that have hollows their coverage. Brushed surfaces keep their tangent in place of the coverage (stages/geometry.frag).
void add_hollows(Needs& needs, Shapes& shapes) {
  for (Draw& draw : needs.draws.all) {
    if (draw.role != Role::opaque || value_of(draw.key, Feature::environment) == 0
        || value_of(draw.key, Feature::anisotropy) != 0)
      continue;
    if (!needs.hollows) needs.hollows = shapes.hollows();
    const auto found = needs.hollows->of.find(place_in(*needs.scene, needs.draws, draw));
    if (found == needs.hollows->of.end()) continue;
    set_value(draw.key, Feature::hollows, 1);
    constexpr int location = 8; // of stages/opaque.vert
    draw.inputs.push_back(
        {location, 1, static_cast<scene::Index>(needs.scene->streams.size() + found->second)});
  }
}

bool has_light(const scene::Scene& scene, const View& view) {
  return view.environment || !scene.lights.empty()
         || std::ranges::any_of(scene.materials, [](const scene::Material& m) {
              return m.unlit || m.emissive != glm::vec3(0.0f);
            });
}

// Without an environment opaque bodies reflect what lights their neighbours.
void add_lobes_of_neighbours(std::vector<Draw>& draws, const View& view) {
  for (Draw& draw : draws) {
    if (draw.role == Role::refractive || value_of(draw.key, Feature::environment) != 0
        || value_of(draw.key, Feature::neighbours) == 0)
      continue;
    const bool smooth = value_of(draw.key, Feature::smooth) != 0;
    const tables::Model model = model_of(*draw.material, view.correlated_smith);
    set_value(draw.key, Feature::lobe_count, smooth ? 1 : reflection_lobes(view.method, model));
  }
}

// Of one lobe, where it is looked up.
int lookups_per_lobe(Method method, int lobes) {
  const int number = static_cast<int>(method);
  return number >= first_fis ? number - first_fis : std::max(lobes, 1);
}

} // namespace

Lookups lookups_of(const Draw& draw, Method method) {
  Lookups lookups;
  // Glass reflects little: its lobes are merged into one (stages/environment_light.glsl).
  const bool refracts = draw.role == Role::refractive;
  if (value_of(draw.key, Feature::lobe_count) != 0)
    lookups.reflected =
        refracts ? 1 : lookups_per_lobe(method, value_of(draw.key, Feature::lobe_count));
  if (!refracts) return lookups;
  if (draw.is_straight()) {
    lookups.refracted = 1;
    return lookups;
  }
  // Dispersion: each channel has its own lobes.
  const int ways = value_of(draw.key, Feature::dispersion) != 0 ? 3 : 1;
  lookups.refracted = ways * lookups_per_lobe(method, interface_lobes(method));
  if (value_of(draw.key, Feature::interior_pairs) == 0) return lookups;
  lookups.internally_reflected = ways;
  // Diffuse internal scattering is looked up before the viewer and behind (stages/glass_inside.glsl).
  const bool scatters =
      value_of(draw.key, Feature::interior_pairs) > 1 && value_of(draw.key, Feature::smooth) == 0;
  lookups.residual = scatters ? 2 * ways : ways;
  return lookups;
}

std::size_t Needs::triangle_count() const {
  std::size_t count = 0;
  for (const Draw& draw : draws.all)
    count += draw.index_count / 3;
  return count;
}

const scene::Stream& Needs::stream(scene::Index i) const {
  const auto at = static_cast<std::size_t>(i), own = scene->streams.size();
  return at < own ? scene->streams[at] : hollows->streams[at - own];
}

std::vector<const Draw*> Needs::read() const {
  std::vector<const Draw*> read;
  for (const std::vector<Draw>* list : {&draws.all, &shadows.casters, &shadows.filters})
    for (const Draw& draw : *list)
      read.push_back(&draw);
  return read;
}

Needs needs_of(const scene::Scene& scene, const View& view, Shapes* shapes) {
  Shapes own(scene);
  if (!shapes) shapes = &own;
  Needs needs;
  needs.scene = &scene;
  needs.view = view;
  needs.draws = draws_of(scene, view, *shapes);
  needs.sky = view.environment.has_value();
  needs.has_neighbours = needs.sky && needs.draws.all.size() > 1 && view.method != Method::standard;
  if (view.method != Method::standard) needs.walls = walls_of(scene, needs.draws);
  if (view.method != Method::standard && has_light(scene, view)) {
    needs.proxies = shapes->proxies();
    if (!has(view.without, Feature::neighbours))
      find_neighbours(needs.draws, scene, *needs.proxies);
    add_lobes_of_neighbours(needs.draws.all, view);
  }
  if (view.method != Method::standard && !has(view.without, Feature::hollows))
    add_hollows(needs, *shapes);
  if (!has(view.without, Feature::lights))
    needs.shadows = shadow_maps_of(scene, view, needs.draws, *shapes, needs.proxies.get());
  mark_deferred(needs.draws.all, view);
  needs.bounds = bounds_of(needs.draws.all, scene.bounds);
  sort_opaque(needs);
  sort_layers(needs);
  needs.tables = tables_of(needs.draws.all, view);
  needs.images = images_of(scene, needs.read());
  needs.streams = streams_of(needs.read());
  needs.index_lists = index_lists_of(needs.read());
  for (const Draw& draw : needs.draws.all) {
    const Lookups most = lookups_of(draw, view.method);
    for (int Lookups::*kind : {&Lookups::reflected, &Lookups::refracted,
                               &Lookups::internally_reflected, &Lookups::residual})
      needs.lookups.*kind = std::max(needs.lookups.*kind, most.*kind);
  }
  return needs;
}

} // namespace gg::needs
