#include "needs/shadow_maps.h"

#include "needs/flat.h"
#include "uniforms/camera.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <numbers>
#include <optional>

namespace gg::needs {
namespace {

// Texels for each pixel of the picture's longer side: the filter is three texels wide, the picture's own a pixel.
constexpr int texels_per_pixel = 2;
constexpr int least_size = 256, largest_size = 2048;
constexpr double filter_margin = 3.0; // texels around what a map holds, for the filter's reach
constexpr double widest_cone =
    70.0 * std::numbers::pi
    / 180.0; // radians from the axis: past it texels at the edge are 3 times as
             // wide as in the middle, and faces of a cube do better
constexpr double on_plane = 1e-3; // of its size: bodies on a floor reach below it by rounding

glm::dvec3 corner_of(const scene::Bounds& box, unsigned i) {
  return {i & 1u ? box.high.x : box.low.x, i & 2u ? box.high.y : box.low.y,
          i & 4u ? box.high.z : box.low.z};
}

struct Rectangle {
  glm::dvec2 low{INFINITY}, high{-INFINITY};
  void include(const glm::dvec2& p) { low = glm::min(low, p), high = glm::max(high, p); }
  bool empty() const { return !(low.x < high.x && low.y < high.y); }
};

Rectangle common(const Rectangle& a, const Rectangle& b) {
  return {glm::max(a.low, b.low), glm::min(a.high, b.high)};
}

using Boxes = std::vector<scene::Bounds>;

// What the boxes cover of a view, -1 to 1; all of it if one reaches behind its eye.
Rectangle covered(const Boxes& boxes, const glm::dmat4& clip_from_world) {
  Rectangle area;
  for (const scene::Bounds& box : boxes)
    for (unsigned i = 0; i < 8; ++i) {
      const glm::dvec4 c = clip_from_world * glm::dvec4(corner_of(box, i), 1.0);
      if (!(c.w > 0.0)) return {glm::dvec2(-1.0), glm::dvec2(1.0)};
      area.include(glm::dvec2(c) / c.w);
    }
  return common(area, {glm::dvec2(-1.0), glm::dvec2(1.0)});
}

scene::Bounds around(const Boxes& boxes) {
  scene::Bounds all;
  for (const scene::Bounds& box : boxes) {
    all.include(box.low);
    all.include(box.high);
  }
  return all;
}

// A camera at `eye` that looks along `direction`.
scene::Camera camera(const glm::dvec3& eye, const glm::dvec3& direction) {
  const glm::dvec3 up =
      std::abs(direction.y) < 0.9 ? glm::dvec3(0.0, 1.0, 0.0) : glm::dvec3(1.0, 0.0, 0.0);
  const glm::dvec3 right = glm::normalize(glm::cross(direction, up));
  scene::Camera camera;
  camera.world =
      glm::mat4(glm::dmat4(glm::dvec4(right, 0.0), glm::dvec4(glm::cross(right, direction), 0.0),
                           glm::dvec4(-direction, 0.0), glm::dvec4(eye, 1.0)));
  return camera;
}

ShadowView view_from(const scene::Camera& camera, const glm::dvec3& direction) {
  return {.clip_from_world =
              uniforms::clip_from_view(camera, 1.0) * uniforms::view_from_world(camera),
          .eye = glm::dvec3(camera.world[3]),
          .direction = direction,
          .from_afar = camera.orthographic};
}

// The view with nothing but what both cover; false if that is nothing.
bool crop(ShadowView& view, const Boxes& casters, const Boxes& receivers, int size) {
  Rectangle area =
      common(covered(casters, view.clip_from_world), covered(receivers, view.clip_from_world));
  if (area.empty()) return false;
  const glm::dvec2 centre = 0.5 * (area.low + area.high);
  const glm::dvec2 half =
      0.5 * (area.high - area.low) * (1.0 + 2.0 * filter_margin / (size - 2.0 * filter_margin));
  glm::dmat4 cut(1.0);
  cut[0][0] = 1.0 / half.x;
  cut[1][1] = 1.0 / half.y;
  cut[3][0] = -centre.x / half.x; // times w, which divides it
  cut[3][1] = -centre.y / half.y;
  view.clip_from_world = cut * view.clip_from_world;
  return true;
}

// Where a view from a point has to begin: before all that casts, where that is before it; else close by.
double near_plane(const glm::dvec3& eye, const glm::dvec3& axis, const Boxes& casters,
                  double farthest) {
  double nearest = farthest;
  for (const scene::Bounds& box : casters)
    for (unsigned i = 0; i < 8; ++i)
      nearest = std::min(nearest, glm::dot(axis, corner_of(box, i) - eye));
  // Float depth keeps three digits at the far end of a range of ten thousand.
  return std::max(0.9 * nearest, 1e-4 * farthest);
}

std::vector<ShadowView> views_of(const scene::Light& light, const Boxes& casters,
                                 const Boxes& receivers, int size) {
  const scene::Bounds cast = around(casters), lit = around(receivers);
  scene::Bounds all = cast;
  all.include(lit.low);
  all.include(lit.high);
  const glm::dvec3 centre(all.centre());
  // A point has some extent: the view must not be singular.
  const double radius = std::max(static_cast<double>(all.radius()), 1e-6);
  if (light.kind == scene::LightKind::directional) {
    const glm::dvec3 direction = glm::normalize(glm::dvec3(light.direction));
    scene::Camera c = camera(centre - 1.01 * radius * direction, direction);
    c.orthographic = true;
    c.magnification = glm::vec2(static_cast<float>(1.01 * radius));
    c.near = 0.0f;
    c.far = static_cast<float>(2.02 * radius);
    ShadowView view = view_from(c, direction);
    if (!crop(view, casters, receivers, size)) return {};
    return {view};
  }
  const glm::dvec3 eye(light.position);
  const double farthest = glm::length(centre - eye) + radius;
  const auto looking = [&](const glm::dvec3& axis, double half_angle) {
    scene::Camera c = camera(eye, axis);
    c.fovy = static_cast<float>(2.0 * half_angle);
    c.near = static_cast<float>(near_plane(eye, axis, casters, farthest));
    return view_from(c, axis);
  };
  const double outer = static_cast<double>(light.outer_cone);
  if (light.kind == scene::LightKind::spot && outer < widest_cone) {
    // A milliradian more than the cone: two texels of the largest map, so that its rim is inside.
    ShadowView view = looking(glm::normalize(glm::dvec3(light.direction)), outer + 1e-3);
    if (!crop(view, casters, receivers, size)) return {};
    return {view};
  }
  // What casts as seen from outside of it: one view.
  const glm::dvec3 to = glm::dvec3(cast.centre()) - eye;
  const double away = glm::length(to), reach = static_cast<double>(cast.radius());
  if (reach < std::sin(widest_cone) * away) {
    // The same here.
    ShadowView view = looking(to / away, std::asin(reach / away) + 1e-3);
    if (!crop(view, casters, receivers, size)) return {};
    return {view};
  }
  std::vector<ShadowView> faces;
  for (int axis = 0; axis < 3; ++axis)
    for (const double sign : {1.0, -1.0}) {
      glm::dvec3 direction(0.0);
      direction[axis] = sign;
      faces.push_back(looking(direction, std::atan(1.0 + 2.0 * filter_margin / size)));
    }
  return faces;
}

// The plane of what is flat along an axis of its mesh.
struct Plane {
  glm::dvec3 point, normal;
};
std::optional<Plane> plane_of(const Draw& draw, const scene::Instance& instance) {
  const glm::dvec3 size(draw.primitive->bounds.high - draw.primitive->bounds.low);
  int axis = 0;
  for (int k = 1; k < 3; ++k)
    if (size[k] < size[axis]) axis = k;
  if (size[axis] > flat_below * std::max({size.x, size.y, size.z})) return std::nullopt;
  const glm::dmat3 world(instance.world);
  const glm::dvec3 normal = glm::cross(world[(axis + 1) % 3], world[(axis + 2) % 3]);
  if (!(glm::length(normal) > 0.0)) return std::nullopt;
  return Plane{
      glm::dvec3(glm::dmat4(instance.world) * glm::dvec4(draw.primitive->bounds.centre(), 1.0)),
      glm::normalize(normal)};
}

// Whether something of what is lit is behind the caster as the light sees it: what is flat hides nothing on its lit side.
bool hides_any(const Draw& caster, const Draws& draws, const std::vector<const Draw*>& receivers,
               const scene::Light& light) {
  const auto plane = plane_of(caster, *draws.instances[caster.instance_index]);
  if (!plane) return true;
  const glm::dvec3 towards = light.kind == scene::LightKind::directional
                                 ? -glm::dvec3(light.direction)
                                 : glm::dvec3(light.position) - plane->point;
  const double side = glm::dot(plane->normal, towards) < 0.0 ? -1.0 : 1.0;
  const double least = -on_plane * static_cast<double>(caster.bounds.radius());
  return std::ranges::any_of(receivers, [&](const Draw* receiver) {
    if (receiver->primitive == caster.primitive
        && receiver->instance_index == caster.instance_index)
      return false;
    for (unsigned i = 0; i < 8; ++i)
      if (side * glm::dot(plane->normal, corner_of(receiver->bounds, i) - plane->point) < least)
        return true;
    return false;
  });
}

// Whether the draw's proxy is a ball of glass.
bool is_lens(const Draw& draw, const scene::Scene& scene, const Draws& draws,
             const Proxies& proxies) {
  const auto own = proxies.bodies.find(place_in(scene, draws, draw));
  return own != proxies.bodies.end() && std::ranges::any_of(proxies.all, [&](const Proxy& proxy) {
           return proxy.body == own->second && is_lens(proxy);
         });
}

// What a caster's depth takes of its material: whether there is a hole.
Draw for_depth(const Draw& draw) {
  Draw caster = draw;
  caster.neighbours.clear();
  if (draw.material->alpha_mode == scene::AlphaMode::mask) return caster;
  caster.key = FeatureKey{};
  caster.maps.clear();
  std::erase_if(caster.inputs, [](const VertexInput& input) { return input.location > 1; });
  return caster;
}

} // namespace

ShadowMaps shadow_maps_of(const scene::Scene& scene, const View& view, Draws& draws, Shapes& shapes,
                          const Proxies* proxies) {
  ShadowMaps maps;
  if (scene.lights.empty()) return maps;
  std::vector<const Draw*> receivers;
  Boxes lit;
  for (const Draw& draw : draws.all)
    if (value_of(draw.key, Feature::lights) != 0) {
      receivers.push_back(&draw);
      lit.push_back(draw.bounds);
    }
  if (receivers.empty()) return maps;
  for (const std::vector<Draw>* list : {&draws.all, &draws.outside_view})
    for (const Draw& draw : *list) {
      if (draw.role == Role::opaque)
        maps.casters.push_back(for_depth(draw));
      else if (!proxies || !is_lens(draw, scene, draws, *proxies))
        maps.filters.push_back(draw), maps.filters.back().neighbours.clear();
    }
  if (maps.casters.size() + maps.filters.size() == 1) {
    const Draw& alone = maps.casters.empty() ? maps.filters.front() : maps.casters.front();
    const scene::SolidShape& shape = shapes.of(*draws.instances[alone.instance_index], alone.body);
    const bool itself = receivers.size() == 1 && receivers.front()->primitive == alone.primitive;
    if (itself && (shape.convex || shape.planar)) return {};
  }
  maps.size = std::clamp(static_cast<int>(std::bit_ceil(static_cast<unsigned>(
                             texels_per_pixel * std::max(view.width, view.height)))),
                         least_size, largest_size);
  for (const scene::Light& light : scene.lights) {
    Boxes casting;
    for (const std::vector<Draw>* list : {&maps.casters, &maps.filters})
      for (const Draw& draw : *list)
        if (hides_any(draw, draws, receivers, light)) casting.push_back(draw.bounds);
    LightViews& own = maps.of_light.emplace_back();
    std::vector<ShadowView> views;
    if (!casting.empty()) views = views_of(light, casting, lit, maps.size);
    own.first = maps.views.size();
    own.nothing_casts = views.empty();
    if (maps.views.size() + views.size() > most_shadow_views) continue;
    own.count = views.size();
    maps.views.insert(maps.views.end(), views.begin(), views.end());
  }
  if (maps.views.empty()) return {};
  for (Draw& draw : draws.all)
    if (value_of(draw.key, Feature::lights) != 0)
      set_value(draw.key, Feature::lights, maps.filters.empty() ? 2 : 3);
  return maps;
}

} // namespace gg::needs
