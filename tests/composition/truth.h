// What two rough interfaces really do with light: paths through both, drawn from the microfacet model itself.
#pragma once

#include "tables/lobe.h"

#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <functional>
#include <string>
#include <vector>

namespace gg::composition_test {

constexpr double degree = 0.017453292519943295;

// The exit as a ray from the entry meets it: the outward normal, and how fast it turns.
struct Exit {
  glm::dvec3 n{0.0};
  glm::dvec2 turn{
      0.0}; // ExitSurface.turn: in the plane of incidence and across it, per radian of the ray
};

// Where rays that enter at one point of a solid leave it again. The entry's normal is +z.
struct Solid {
  std::string family; // slab, sphere, wedge +, wedge -, wedge out, ...
  std::string name;
  std::function<Exit(const glm::dvec3& direction)> exit;
};
Solid slab();
Solid sphere();
// The exit is tilted against the entry: in the plane of incidence (+ turns it towards the ray: less oblique), or across it.
Solid wedge(double degrees);
Solid wedge_out(double degrees);
// Entered at the middle of its flat top, left through its curved underside: an ellipsoid, whose middle is `depth` below the
// top, cut off there. Half axes along x, y, z; an axis much longer than the others makes a cylinder.
Solid lens(const std::string& name, const glm::dvec3& half_axes, double depth,
           double turned_degrees = 0.0);

struct Configuration {
  Solid solid;
  tables::Model model;
  double alpha1 = 0.0, alpha2 = 0.0;
  double eta = 1.5;   // inside over outside, below 1 for a bubble
  double theta = 0.0; // degrees
  std::string label() const;
  glm::dvec3 wo() const; // in the plane y = 0, x > 0
};

struct Path {
  glm::vec3 direction; // travelling outside
  float weight = 0.0f;
};

struct Truth {
  std::vector<Path> paths; // those that get through; weights sum to `energy`
  double entered =
      0.0; // share of the light that passes the first face (whatever meets the exit or not)
  double energy = 0.0;    // share that passes both
  double reflected = 0.0; // share that the exit reflects inside
  double spread = 0.0;    // radians: median angle from the mean direction
};

// `count` points of a four-dimensional lattice; where fewer than a tenth of the light gets through, four times as many. Walter's
// model: one facet at each face.
Truth brute_force(const Configuration& c, int count);

} // namespace gg::composition_test
