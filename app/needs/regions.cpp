#include "needs/regions.h"

#include <algorithm>

namespace gg::needs {
namespace {

// Pixels of the picture in the box around a mesh, per triangle, below which the mesh is fine. About half of the triangles face the
// viewer, so one then covers no more than two of the blocks of 4 x 4 pixels that llvmpipe shades, and touches several. Just below
// that, where a mesh stands alone and is shaded but once, pixels take two thirds of the time of triangles there (Suzanne in gold,
// 320 x 320: 22 and 34 ms of both cores); where it reflects others, and is shaded twice, half at 12. GPUs shade blocks of 2 x 2 and
// would want a smaller number; what they lose by this one is a pass over the picture.
constexpr double fine = 16.0;

// A texel keeps what these say (stages/packed_maps.glsl).
bool is_kept(const Draw& draw, Feature map) {
  switch (map) {
  case Feature::base_color_map:
  case Feature::metallic_roughness_map:
  case Feature::occlusion_map:
  case Feature::emissive_map:
    return true;
  case Feature::normal_map: // of coat and brushing the mesh's own normal is read, too
    return value_of(draw.key, Feature::clearcoat) == 0
           && value_of(draw.key, Feature::anisotropy) == 0;
  default:
    return false;
  }
}

// Without light there is nothing to save. A mask that nothing varies hides all or nothing.
bool can_be_by_pixel(const Draw& draw) {
  const bool masks_nothing = draw.material->alpha_mode == scene::AlphaMode::mask
                             && value_of(draw.key, Feature::base_color_map) == 0
                             && value_of(draw.key, Feature::vertex_color) == 0;
  return draw.role == Role::opaque && !masks_nothing
         && value_of(draw.key, Feature::shading) != static_cast<int>(Shading::unlit)
         && std::ranges::all_of(map_kinds, [&](const MapKind& map) {
              return value_of(draw.key, map.feature) == 0 || is_kept(draw, map.feature);
            });
}

// Coats and brushing have lobes of their own, what passes diffuse light a second irradiance; importance sampling is noise.
bool can_interpolate(const Draw& draw) {
  const auto method = static_cast<Method>(value_of(draw.key, Feature::method));
  const auto lacks = [&](Feature feature) { return value_of(draw.key, feature) == 0; };
  return !lacks(Feature::neighbours) && !lacks(Feature::environment) && lobes_of(method) > 0
         && lacks(Feature::clearcoat) && lacks(Feature::anisotropy)
         && lacks(Feature::diffuse_transmission);
}

// Pixels of the picture that the box covers.
double pixels_of(const ScreenBox& box, const View& view) {
  const glm::dvec2 size = glm::min(box.high, glm::dvec2(1.0)) - glm::max(box.low, glm::dvec2(-1.0));
  return 0.25 * std::max(size.x, 0.0) * std::max(size.y, 0.0) * view.width * view.height;
}

} // namespace

void mark_deferred(std::vector<Draw>& draws, const View& view) {
  const glm::dmat4 clip = clip_from_world(view);
  for (Draw& draw : draws) {
    if (!can_be_by_pixel(draw)) continue;
    const bool interpolates =
        can_interpolate(draw) && !has(view.without, Feature::interpolated_neighbours);
    set_value(draw.key, Feature::interpolated_neighbours, interpolates);
    const double pixels = pixels_of(screen_box(draw.bounds, clip), view);
    const double triangles = static_cast<double>(draw.index_count) / 3.0;
    draw.by_pixel = interpolates || pixels < fine * triangles;
  }
}

bool keeps_maps(const Draw& draw) {
  return !draw.maps.empty() || value_of(draw.key, Feature::vertex_color) != 0
         || draw.material->alpha_mode == scene::AlphaMode::mask;
}

std::vector<Region> opaque_regions_of(const std::vector<const Draw*>& draws, const View& view) {
  const glm::dmat4 clip = clip_from_world(view);
  std::vector<Region> regions;
  for (const Draw* draw : draws) {
    const ScreenBox box = screen_box(draw->bounds, clip);
    const auto found = std::ranges::find_if(regions, [&](const Region& region) {
      const Draw& first = *region.draws.front();
      return first.material_index == draw->material_index && first.key == draw->key
             && first.neighbours == draw->neighbours
             && (draw->neighbours.empty() || first.own_proxy == draw->own_proxy);
    });
    if (found == regions.end()) {
      regions.push_back({{draw}, box});
    } else {
      found->draws.push_back(draw);
      grow(found->box, box);
    }
  }
  return regions;
}

} // namespace gg::needs
