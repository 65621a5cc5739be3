#include "needs/draws.h"

#include "needs/tables.h"
#include "scene/solid_shape.h"
#include "uniforms/camera.h"

#include <algorithm>
#include <map>
#include <utility>

namespace gg::needs {
namespace {

// Attribute locations of stages/opaque.vert; each has a vertex binding of its own, as glTF's
// streams are separate.
constexpr int position_location = 0, normal_location = 1, tangent_location = 2, color_location = 3,
              uv_location = 4;

std::vector<VertexInput> inputs_of(const Features& features, const scene::Primitive& p) {
  std::vector<VertexInput> inputs{{position_location, 3, p.positions},
                                  {normal_location, 3, p.normals}};
  if (value_of(features.key, Feature::normal_map) > 0
      || value_of(features.key, Feature::clearcoat_normal_map) > 0
      || value_of(features.key, Feature::anisotropy) > 0)
    inputs.push_back({tangent_location, 4, p.tangents});
  if (value_of(features.key, Feature::vertex_color) > 0)
    inputs.push_back({color_location, 4, p.colors});
  int location = uv_location;
  for (const int set : features.uv_sets)
    inputs.push_back({location++, 2, p.uvs[static_cast<std::size_t>(set)]});
  return inputs;
}

std::vector<Map> maps_of(const FeatureKey& key, const scene::Material& material) {
  std::vector<Map> maps;
  for (const MapKind& kind : map_kinds)
    if (value_of(key, kind.feature) > 0)
      maps.push_back({kind.name, (material.*kind.slot).texture, kind.srgb});
  return maps;
}

glm::vec3 corner(const scene::Bounds& box, unsigned i) {
  return {i & 1u ? box.high.x : box.low.x, i & 2u ? box.high.y : box.low.y,
          i & 4u ? box.high.z : box.low.z};
}

scene::Bounds world_bounds(const scene::Bounds& bounds, const glm::mat4& world) {
  scene::Bounds result;
  if (bounds.empty()) return result;
  for (unsigned i = 0; i < 8; ++i)
    result.include(glm::vec3(world * glm::vec4(corner(bounds, i), 1.0f)));
  return result;
}

Role role_of(const scene::Material& material) {
  if (is_refractive(material)) return Role::refractive;
  return material.alpha_mode == scene::AlphaMode::blend ? Role::blended : Role::opaque;
}

bool same_body(const Draw& a, const Draw& b) {
  return a.is_solid() && b.is_solid() && a.instance_index == b.instance_index && a.body == b.body;
}

// Whether parts of another material bound the same body.
bool shares_body(const Draw& draw, const std::vector<Draw>& draws) {
  return std::ranges::any_of(draws, [&](const Draw& other) {
    return same_body(draw, other) && draw.material_index != other.material_index;
  });
}

// A smooth part of a body that is rough elsewhere: rays leave it by rough faces, whose lobes are in tables.
void let_leave_by_rough_faces(std::vector<Draw>& draws, const View& view) {
  const auto is_smooth = [](const Draw& d) { return value_of(d.key, Feature::smooth) != 0; };
  for (Draw& draw : draws) {
    if (!draw.is_solid() || !is_smooth(draw)) continue;
    if (std::ranges::none_of(
            draws, [&](const Draw& other) { return same_body(draw, other) && !is_smooth(other); }))
      continue;
    set_value(draw.key, Feature::smooth, 0);
    if (value_of(draw.key, Feature::environment) != 0)
      set_value(draw.key, Feature::lobe_count,
                reflection_lobes(view.method, model_of(*draw.material, view.correlated_smith)));
  }
}

// Whether something that is in the depth when the solid is drawn reaches into the box around it: something opaque, or glass that
// makes an image and lies within. A floor touches a body on it: a thousandth of the solid's size does not count.
bool holds_something(const Draw& solid, const std::vector<Draw>& draws) {
  const glm::vec3 least(1e-3f * solid.bounds.radius());
  return std::ranges::any_of(draws, [&](const Draw& other) {
    const bool within = other.images && !same_body(solid, other)
                        && glm::all(glm::greaterThan(other.bounds.low, solid.bounds.low))
                        && glm::all(glm::lessThan(other.bounds.high, solid.bounds.high));
    return (other.role == Role::opaque || other.fills_depth || within)
           && glm::all(glm::greaterThan(other.bounds.high, solid.bounds.low + least))
           && glm::all(glm::lessThan(other.bounds.low, solid.bounds.high - least));
  });
}

// Base colour or clear share, which each face that light passes applies, are not the same on all faces of the body.
bool faces_differ(const Draw& draw, const std::vector<Draw>& draws) {
  const scene::Material& m = *draw.material;
  const auto varies = [](const Draw& d) {
    for (const Feature feature :
         {Feature::base_color_map, Feature::transmission_map, Feature::vertex_color})
      if (value_of(d.key, feature) != 0) return true;
    return value_of(d.key, Feature::metallic_roughness_map) != 0 && d.material->metallic > 0.0f;
  };
  return varies(draw) || std::ranges::any_of(draws, [&](const Draw& other) {
           const scene::Material& o = *other.material;
           return same_body(draw, other)
                  && (varies(other) || o.base_color != m.base_color
                      || o.transmission != m.transmission || o.metallic != m.metallic);
         });
}

// Pairs of a front and a back face that the rays inside are followed through. `standard` takes the material's
// thickness for the way inside; what bends nothing needs it only where it absorbs, and then from its first front to its first back.
int interior_pairs(const Draw& draw, const View& view, const scene::Instance& instance,
                   Shapes& shapes) {
  if (!draw.is_solid() || view.method == Method::standard) return 0;
  if (draw.is_straight()) return value_of(draw.key, Feature::attenuation);
  return shapes.of(instance, draw.body).convex ? 1 : 2;
}

// Whether the near plane cuts into the box: the camera may stand in what is in it.
bool is_cut_open(const scene::Bounds& box, const glm::dmat4& clip_from_world) {
  for (unsigned i = 0; i < 8; ++i) {
    const glm::dvec4 c = clip_from_world * glm::dvec4(corner(box, i), 1.0);
    if (!(c.w > 0.0 && c.z <= c.w)) return true;
  }
  return false;
}

// Whether back faces of a solid can be what is seen. Those of a closed one are there to be seen from within, whatever its
// material says of sides; an open one shows them if the material has two.
bool is_seen_from_within(const Draw& draw, const scene::SolidShape& shape,
                         const glm::dmat4& clip_from_world) {
  return shape.closed ? is_cut_open(draw.bounds, clip_from_world) : draw.both_sides;
}

// `standard` shades glass like any surface, and the layer holds depth, normal and alpha alone.
bool is_by_pixel(const Draw& draw) {
  const auto maps = static_cast<std::size_t>(
      value_of(draw.key, Feature::metallic_roughness_map) != 0 && draw.material->metallic <= 0.0f);
  return value_of(draw.key, Feature::interior_pairs) > 0 && !draw.is_straight()
         && value_of(draw.key, Feature::seen_from_within) == 0
         && value_of(draw.key, Feature::vertex_color) == 0
         && value_of(draw.key, Feature::anisotropy) == 0 && draw.maps.size() == maps
         && draw.material->alpha_mode != scene::AlphaMode::mask;
}

// Where a solid is closed the search within finds its far side: the thickness of a plate (stages/glass_inside.glsl) stands in
// only where that finds nothing, and the factor does for it.
void leave_thickness_map(Draw& draw) {
  if (value_of(draw.key, Feature::thickness_map) == 0) return;
  set_value(draw.key, Feature::thickness_map, 0);
  draw.maps = maps_of(draw.key, *draw.material);
  if (!draw.maps.empty()) return;
  set_value(draw.key, Feature::uv_sets, 0);
  std::erase_if(draw.inputs,
                [](const VertexInput& input) { return input.location >= uv_location; });
}

// Where something is in a list that holds everything once.
template <class T>
std::size_t place_in(std::vector<const T*>& list, std::map<const T*, std::size_t>& places,
                     const T* thing) {
  const auto [at, is_new] = places.try_emplace(thing, list.size());
  if (is_new) list.push_back(thing);
  return at->second;
}

} // namespace

glm::dmat4 clip_from_world(const View& view) {
  const double aspect = static_cast<double>(view.width) / view.height;
  return uniforms::clip_from_view(view.camera, aspect) * uniforms::view_from_world(view.camera);
}

bool is_outside(const scene::Bounds& bounds, const glm::dmat4& clip_from_world, int width,
                int height) {
  // Beyond one plane of the view with all its corners: clip coordinates are linear, so what lies between is, too. A number
  // that is none is beyond no plane.
  const double right = 1.0 + 2.0 / width, top = 1.0 + 2.0 / height;
  unsigned beyond = 63u;
  for (unsigned i = 0; i < 8; ++i) {
    const glm::dvec4 c = clip_from_world * glm::dvec4(corner(bounds, i), 1.0);
    const bool tests[] = {c.x > right * c.w, c.x<-right * c.w, c.y> top * c.w, c.y < -top * c.w,
                          c.z<0.0, c.z> c.w};
    for (unsigned k = 0; k < 6; ++k)
      if (!tests[k]) beyond &= ~(1u << k);
  }
  return beyond != 0;
}

std::pair<std::size_t, std::size_t> place_in(const scene::Scene& scene, const Draws& draws,
                                             const Draw& draw) {
  const scene::Instance* instance = draws.instances[draw.instance_index];
  const auto& primitives = scene.meshes[static_cast<std::size_t>(instance->mesh)].primitives;
  return {static_cast<std::size_t>(instance - scene.instances.data()),
          static_cast<std::size_t>(draw.primitive - primitives.data())};
}

Draws draws_of(const scene::Scene& scene, const View& view, Shapes& shapes) {
  const FrameFeatures frame{.method = view.method,
                            .correlated_smith = view.correlated_smith,
                            .multiple_scattering = view.multiple_scattering,
                            .environment = view.environment.has_value(),
                            .lights = !scene.lights.empty() && !has(view.without, Feature::lights),
                            .without = view.without};
  const glm::dmat4 clip = clip_from_world(view);
  const glm::vec3 eye(view.camera.world[3]);
  const glm::vec3 forward = -glm::normalize(glm::vec3(view.camera.world[2]));
  Draws draws;
  std::map<const scene::Material*, std::size_t> materials;
  std::map<const scene::Instance*, std::size_t> instances;
  for (const scene::Instance& instance : scene.instances)
    for (const scene::Primitive& primitive :
         scene.meshes[static_cast<std::size_t>(instance.mesh)].primitives) {
      const scene::Material& material =
          scene.materials[static_cast<std::size_t>(primitive.material)];
      const scene::Bounds bounds = world_bounds(primitive.bounds, instance.world);
      const bool outside = bounds.empty() || is_outside(bounds, clip, view.width, view.height);
      if (outside) ++draws.outside;
      if (outside && (bounds.empty() || scene.lights.empty())) continue;
      if (is_invisible(material, primitive)) {
        draws.invisible += outside ? 0 : 1;
        continue;
      }
      const Features features = features_of(scene, material, primitive, frame);
      Draw& draw = (outside ? draws.outside_view : draws.all).emplace_back();
      draw.primitive = &primitive;
      draw.material = &material;
      draw.material_index = place_in(draws.materials, materials, &material);
      draw.body = shapes.body(primitive.material);
      if (draws.bodies.size() < draws.materials.size()) draws.bodies.push_back(draw.body);
      draw.instance_index = place_in(draws.instances, instances, &instance);
      draw.role = role_of(material);
      draw.key = features.key;
      if (value_of(draw.key, Feature::environment) != 0)
        set_value(draw.key, Feature::lobe_count,
                  value_of(draw.key, Feature::smooth) != 0
                      ? 1
                      : reflection_lobes(view.method, model_of(material, view.correlated_smith)));
      draw.bounds = bounds;
      const glm::vec3 centre(instance.world * glm::vec4(primitive.bounds.centre(), 1.0f));
      draw.distance = static_cast<double>(glm::dot(centre - eye, forward));
      draw.inputs = inputs_of(features, primitive);
      draw.maps = maps_of(draw.key, material);
      draw.index_count = scene.indices[static_cast<std::size_t>(primitive.indices)].size();
      draw.mirrored = instance.mirrored;
      draw.both_sides = material.double_sided;
      draw.fills_depth = draw.role == Role::blended && material.base_color.a >= 0.5f;
    }
  let_leave_by_rough_faces(draws.all, view);
  for (Draw& draw : draws.all) {
    const scene::Instance& instance = *draws.instances[draw.instance_index];
    const int pairs = interior_pairs(draw, view, instance, shapes);
    set_value(draw.key, Feature::interior_pairs, pairs);
    draw.planar = draw.role == Role::refractive && !draw.is_solid() && draw.both_sides
                  && shapes.of(instance, draw.primitive->material).planar;
    if (!draw.is_solid() || view.method == Method::standard) continue;
    const scene::SolidShape& shape = shapes.of(instance, draw.body);
    if (shape.closed) leave_thickness_map(draw);
    draw.images = !draw.is_straight() && !(shape.flat && shape.convex);
    draw.both_sides = is_seen_from_within(draw, shape, clip);
    set_value(draw.key, Feature::seen_from_within, draw.both_sides);
    draw.by_pixel = is_by_pixel(draw) && !shares_body(draw, draws.all);
  }
  for (Draw& draw : draws.all)
    if (value_of(draw.key, Feature::interior_pairs) > 0 && !draw.is_straight()) {
      set_value(draw.key, Feature::holds_opaque, holds_something(draw, draws.all));
      set_value(draw.key, Feature::faces_differ, faces_differ(draw, draws.all));
    }
  return draws;
}

} // namespace gg::needs
