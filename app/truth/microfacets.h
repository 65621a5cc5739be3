// The statistics of a rough interface: which microfacets there are, which of them a viewer sees,
// and how many of those light reaches. One distribution at one width; everything is asked through
// the snippets of shaders/bsdf in double precision.
#pragma once

#include "glsl/f64.h"
#include "scene/scene.h"
#include "truth/random.h"

#include <optional>

namespace gg::truth {

enum class Smith {
  separable, // Walter 2007: shadowing and masking independent. The reference model
  correlated // 1 / (1 + Lambda_i + Lambda_o) in reflection, Beta(1 + Lambda_i, 1 + Lambda_o) in
             // transmission (Heitz 2016)
};

class Microfacets {
public:
  using Facet = glsl::f64::Facet;

  // alpha: slope width, in [0, 1]; 0 is a smooth surface, whose lobes are deltas.
  Microfacets(scene::Distribution distribution, double alpha, Smith smith)
      : distribution_(distribution), alpha_(alpha), smith_(smith) {}
  // GGX of two widths, along x and y of the local frame in which directions are given.
  Microfacets(const glm::dvec2& alpha, Smith smith)
      : distribution_(scene::Distribution::ggx), alpha_(alpha.y), smith_(smith), widths_(alpha) {}

  bool smooth() const { return alpha_ == 0.0; }

  // The facet of two directions, and those directions in the local frame, which two widths ask for.
  struct Pair {
    Facet facet;
    glm::dvec3 wi{0.0}, wo{0.0}, h{0.0}; // h of any length
  };
  // D, 1/sr.
  double density(const Pair& p) const;
  // G2 / (4 |wi.n| |wo.n|).
  double shadowing_reflected(const Pair& p) const;
  double shadowing_transmitted(const Pair& p) const;

  // A microfacet normal for a viewer at wo (local, n = +z, wo.z >= 0), and the density per sr with
  // which sample() draws the facet. GGX and Beckmann by the normals that wo sees; Phong, for which
  // no such sampler is known, by D |wm . n|.
  glm::dvec3 sample(const glm::dvec3& wo, Random& random) const;
  double pdf(const Pair& p) const;

private:
  scene::Distribution distribution_;
  double alpha_;
  Smith smith_;
  std::optional<glm::dvec2> widths_;
};

} // namespace gg::truth
