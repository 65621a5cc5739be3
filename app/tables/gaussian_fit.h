// Gaussians fitted to the exact lobe: which direction and which width make one lookup in a Gaussian stack come closest to the
// integral of the lobe over an environment.
#pragma once

#include "tables/lobe.h"
#include "tables/sphere_map.h"

#include <glm/mat3x3.hpp>

#include <vector>

namespace gg::tables {

// One lookup. The direction is normalize((1 - lean) r + lean n): 0 the mirror direction r, 1 the normal.
struct Tap {
  double lean = 0.0;
  double sigma = 0.0; // radians
};

// Environments in many orientations.
class Training {
public:
  struct View {
    int stack = 0;
    glm::mat3 world_from_local{1.0f};
  };
  Training(std::vector<SphereStack> stacks, int rotations_per_map, unsigned seed);
  const std::vector<View>& views() const { return views_; }
  const SphereStack& stack(const View& view) const {
    return stacks_[static_cast<std::size_t>(view.stack)];
  }

private:
  std::vector<SphereStack> stacks_;
  std::vector<View> views_;
};

// What the exact lobe sends back in every view, for two shapes of Fresnel's reflectance: 1, and Schlick's edge
// (1 - cos)^5. Each divided by its own albedo, so a constant environment of 1 gives 1.
struct LobeRadiance {
  std::vector<double> flat, edge;
};
LobeRadiance lobe_radiance(const Training& training, const std::vector<LobeSample>& lobe);

// The radiance in one view of a surface whose energy comes to a share `edge` from Schlick's edge.
inline double mixed(const LobeRadiance& r, std::size_t view, double edge) {
  return (1.0 - edge) * r.flat[view] + edge * r.edge[view];
}

// Root mean square over the views of ln((tap + f) / (truth + f)), f a fifth of the map's geometric mean radiance: relative
// error where there is light, blind to the darkest, and no slave of suns.
double log_error(const Training& training, const LobeRadiance& truth, double edge, double cos_theta,
                 const Tap& tap);

// The tap with the least log_error: a grid, then Levenberg and Marquardt's method on (lean, ln sigma).
Tap fit(const Training& training, const LobeRadiance& truth, double edge, double alpha,
        double cos_theta);

// What peers do: the mirror direction, and the width that suits the lobe at normal incidence.
inline Tap standard_practice(const Tap& at_normal_incidence) {
  return {0.0, at_normal_incidence.sigma};
}

} // namespace gg::tables
