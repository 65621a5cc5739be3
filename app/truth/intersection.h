// A path of light on its way from the camera, and its intersection with a surface.
#pragma once

#include "truth/crossing.h"

#include <algorithm>

namespace gg::truth {

inline double largest(const glm::dvec3& v) {
  return std::max({v.x, v.y, v.z});
}

// What has been followed so far. `pdf` is the density with which the last direction was drawn if
// direct light was gathered in the same place, 0 otherwise: then what the path meets counts whole.
struct Path {
  Ray ray;
  glm::dvec3 from{
      0.0}; // where it left a surface: the ray starts a rounding off it (Geometry::leave)
  glm::dvec3 throughput{1.0};
  Whereabouts where;
  double pdf = 0.0;
  double open =
      1.0; // factor on the environment: baked occlusion, where paths do not find their own
  double scale = 1.0;  // product of eta² of the interfaces crossed: throughput * scale is power
  int channel = white; // all, or the one that is left after glass that disperses
  int bounces = 0;
  bool scattered = false; // by a surface, if only by refraction

  // In [0, 1]: of what the camera sent out.
  double power() const { return largest(throughput) * scale; }
};

// A path at a surface. A thin wall is two interfaces at one place; the path goes on between them
// until it leaves.
struct Intersection {
  enum class Face {
    first, // where the path came from; the only one, except in a wall
    far,   // the wall's other interface, from inside
    near   // the first interface again, from inside
  };

  Surface surface;
  Face face = Face::first;
  glm::dvec3 wo{0.0};
  Whereabouts before, beyond; // on this side of the surface and on the other
  double ior_before = 1.0, ior_beyond = 1.0;
  bool by_triangle = false; // shading normals gave no direction: the triangle's normal is used

  bool solid() const { return surface.kind == SurfaceKind::solid; }
  // Does wo point into a solid's glass? Both faces of a plate are its.
  bool from_within() const {
    return solid() ? !surface.front : face != Face::first && surface.thickness > 0.0;
  }
  // Does a scattered ray leave the place, or stay in the wall? What is opaque sends diffuse light to its other side at once.
  bool leaves(bool transmitted) const {
    return face == Face::first ? !transmitted || solid() || surface.kind == SurfaceKind::opaque
                               : transmitted;
  }
  // To the other side of the surface, for a ray that leaves?
  bool crosses(bool transmitted) const {
    return face == Face::first ? transmitted : face == Face::far;
  }
  const Whereabouts& where_after(bool transmitted) const {
    return solid() && crosses(transmitted) ? beyond : before;
  }
  bool right_side(const glm::dvec3& wi, bool transmitted) const {
    const double above = glm::dot(wi, surface.geometric);
    return crosses(transmitted) ? above < 0.0 : above > 0.0;
  }
};

// Light that crosses a solid passes two interfaces, and is tinted by the base colour in all.
inline glm::dvec3 tint_of(const Surface& solid) {
  return glm::sqrt(solid.base_color);
}

} // namespace gg::truth
