// The bodies of a scene as simple shapes whose share of a Gaussian lobe has a closed form: spheres and rectangles
// (shaders/neighbours/lobe_share.glsl).
#pragma once

#include "scene/scene.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace gg::needs {

// A sphere, or (radius 0) a rectangle.
struct Proxy {
  glm::vec3 centre{0.0f};
  float radius = 0.0f;                  // metres
  glm::vec3 side_u{0.0f}, side_v{0.0f}; // half of its sides
  bool ball = false;                    // all of the body's surface lies on the sphere
  bool one_sided = false;               // a face of a box: met on the side of cross(side_u, side_v)
  std::size_t body = 0;                 // the body that it replaces, or is part of
  const scene::Material* material = nullptr;
};

// A ball of glass, which focuses light.
bool is_lens(const Proxy& proxy);

struct Proxies {
  std::vector<Proxy> all;
  // The body that a primitive of an instance (indices into the scene and its mesh) is part of.
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> bodies;
};

// Of everything that casts (opaque surfaces, masks and glass; not what is blended), in the world, in or out of the picture.
// Triangles that fill a rectangle, or are flat, are a rectangle of the same area; those that fill the faces of a box are its faces.
// Every other body is a sphere with the mean shadow of its convex hull, which is a quarter of the hull's area [Cauchy 1841], at the
// centroid of these shadows; one that is longer than twice its width, a row of equal ones with that shadow together. Parts of an
// instance that overlap are one body, and so are instances of which one lies within the box of another by four fifths.
Proxies proxies_of(const scene::Scene& scene);

} // namespace gg::needs
