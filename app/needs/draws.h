// What a scene asks to be drawn: one draw per primitive of each instance that can be seen.
#pragma once

#include "needs/features.h"
#include "needs/shapes.h"
#include "needs/view.h"
#include "scene/scene.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace gg::needs {

// How a surface takes part in a frame.
enum class Role {
  opaque,    // hides what is behind it (alpha masks too)
  blended,   // lies over it, by coverage
  refractive // shows it bent: glass
};

// A texture that a draw reads.
struct Map {
  const char* name; // in the shader
  scene::Index texture;
  bool srgb;
};

// A stream of vertices that a draw reads.
struct VertexInput {
  int location = 0, components = 0; // in stages/opaque.vert
  scene::Index stream = scene::none;
};

struct Draw {
  const scene::Primitive* primitive = nullptr;
  const scene::Material* material = nullptr;
  std::size_t material_index = 0, instance_index = 0; // among those that are drawn
  scene::Index body =
      scene::none; // of a solid: its body, as the first of its materials (scene/bodies.h)
  Role role = Role::opaque;
  FeatureKey key{};
  scene::Bounds bounds;  // in the world
  double distance = 0.0; // metres along the view from the eye to the bounds' centre
  std::vector<VertexInput> inputs;
  std::vector<Map> maps;
  std::size_t index_count = 0;
  std::vector<std::uint32_t> neighbours;  // proxies (needs/neighbours.h)
  std::optional<std::uint32_t> own_proxy; // if one proxy is all of its body
  bool mirrored = false, both_sides = false;
  // Blended with an alpha of a half or more, unless a map says otherwise: lookups through glass find it.
  bool fills_depth = false;
  bool planar = false; // glass without thickness in one plane: of its two sides one is seen
  // Deferred shading: glass whose first interior layer holds all that its shading takes
  // from the mesh (stages/refractive_region.frag), and opaque meshes so fine that it pays (stages/opaque_region.frag).
  bool by_pixel = false;
  // Glass that forms an image close by, as lenses do: other glass finds its light at its own depth. Flat glass shows what is behind it
  // where that is.
  bool images = false;

  bool is_solid() const { return role == Role::refractive && material->thickness > 0.0f; }
  // Whether it only transmits, without refraction.
  bool is_straight() const { return value_of(key, Feature::index_one) != 0; }
};

struct Draws {
  std::vector<Draw> all;          // in the order of the scene
  std::vector<Draw> outside_view; // what can cast shadows into it; none without lights
  std::vector<const scene::Material*> materials; // that they use, by material_index
  std::vector<scene::Index> bodies;              // that these bound, by material_index
  std::vector<const scene::Instance*> instances; // by instance_index
  std::size_t outside = 0;   // primitives of instances that are left out: not in the view
  std::size_t invisible = 0; // the same: glass of IOR 1 that does nothing
};

// What a draw is of: indices of its instance into the scene, and of its primitive into the instance's mesh.
std::pair<std::size_t, std::size_t> place_in(const scene::Scene& scene, const Draws& draws,
                                             const Draw& draw);

// `scene` must outlive the result. Primitives outside of the view or invisible are left out.
Draws draws_of(const scene::Scene& scene, const View& view, Shapes& shapes);

// Whether nothing of the box can be within a pixel of the picture: samples lie half a pixel off, and rounding far less.
bool is_outside(const scene::Bounds& bounds, const glm::dmat4& clip_from_world, int width,
                int height);

} // namespace gg::needs
