// The exact single-scattering lobes of a rough surface as weighted directions: what the tables are integrals of and what
// their Gaussians are fitted to. Reflection is that of a surface that reflects everything (F = 1); transmission has its
// Fresnel factor.
#pragma once

#include <glm/vec3.hpp>

#include <array>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace gg::tables {

enum class Distribution { ggx, beckmann, phong };
enum class Smith { separable, correlated };

// A model that has tables of its own. Phong is given by the slope width alpha that its exponent matches.
struct Model {
  Distribution distribution = Distribution::ggx;
  Smith smith = Smith::separable;
};
// In the order in which they are stored and numbered for shaders.
inline constexpr std::array<Model, 4> models = {{{Distribution::ggx, Smith::separable},
                                                 {Distribution::ggx, Smith::correlated},
                                                 {Distribution::beckmann, Smith::separable},
                                                 {Distribution::phong, Smith::separable}}};
std::string name(const Model& model); // "ggx-separable"

// Up to how many lobes there are tables for. Two interfaces compose from two lobes each, and more gain nothing there
// (tests/composition); reflection reads as many as there are. Phong is kept for comparisons.
inline int lobes_of(const Model& model) {
  return model.distribution == Distribution::phong ? 2 : 4;
}

// One direction of the lobe. Local frame: n = +z, wo = (sin, 0, cos), so the mirror direction has x < 0.
struct LobeSample {
  glm::dvec3 wi;
  double cos_facet = 0.0; // wo . wm, at which Fresnel's reflectance is taken
  double weight =
      0.0; // its share of the integral of f cos: sums to the albedo (reflection for F = 1)
  double density = 0.0; // samples per steradian about wi
};

// How the unit square that microfacet normals are drawn from is walked.
enum class Walk {
  grid, // `count` x `count` midpoints, half of the azimuths (the lobe is symmetric): for energies
  lattice, // `count` points of a rank-1 lattice over the whole lobe: for pictures
};

// Directions of the lobe of `model` at width `alpha` > 0, seen at `cos_theta` in [0, 1]: the limit from above at 0.
// Directions below the horizon are left out. Midpoint rule in the coordinates that microfacet normals are sampled in,
// so the error falls with the square of the spacing.
std::vector<LobeSample> reflection_lobe(const Model& model, double alpha, double cos_theta,
                                        Walk walk, int count);

// The transmitted lobe through an interface of index eta = n_far / n_near (not 1), wo on the near side: wi.z < 0, weights
// sum to the share of the power that goes through (no 1 / eta²). At least `count` points are drawn, more (up to 32 times
// as many) where few of them get through; there may still be none, past the critical angle of nearly smooth glass. Points
// crowd towards facets that lean far.
std::vector<LobeSample> transmission_lobe(const Model& model, double alpha, double cos_theta,
                                          double eta, int count);

// Shares of the power that single scattering sends through the interface and back.
struct InterfaceShares {
  double transmitted = 0.0, reflected = 0.0;
};
// `count` squared points on half of the azimuths; 64 are good to 5e-4 (tests/tables).
InterfaceShares interface_shares(const Model& model, double alpha, double cos_theta, double eta,
                                 int count);

// Where a lobe lies in the plane of incidence, and how wide it is: the weighted median of atan2(-x, |z|), 0 along the
// normal, and the weighted median of the angle between a sample and that direction. Both are 0 for an empty lobe.
struct LobeShape {
  double angle = 0.0, width = 0.0;
};
LobeShape shape_of(const std::vector<LobeSample>& lobe);

} // namespace gg::tables
