// Environments that no fit has seen, and how near sums of Gaussians come to lobes on them.
#pragma once

#include "tables/lobe.h"
#include "tables/training.h"

#include <vector>

namespace gg::tables {

// The pictures of assets/environments (luminance) and the held-out draws of the made-up ones, each in `rotations`
// orientations from a seed of their own.
Training held_out_maps(int map_size, int rotations);

// One lookup; local frame as in lobe.h.
struct Lookup {
  glm::dvec3 direction{0.0, 0.0, 1.0};
  double sigma = 0.0, weight = 1.0;
};

// Of the lobe in every view, divided by its energy; `weights` replace the samples' own where they are given. Samples read
// the map through a Gaussian of `spread` times the side of the solid angle that each stands for: even sums for many
// samples; for few (filtered importance sampling) 0.35 is best, by the study that led to these tables.
std::vector<double> radiance(const Training& training, const std::vector<LobeSample>& lobe,
                             const std::vector<double>& weights = {}, double spread = 0.7);

// Of every view, ln((light + f) / (truth + f))², f a fifth of the map's geometric mean radiance: relative error where there is
// light, blind to the darkest, and no slave of suns. The weights of lookups should sum to 1: both sides have one energy.
std::vector<double> squared_log_errors(const Training& training, const std::vector<double>& truth,
                                       const std::vector<double>& light);
std::vector<double> squared_log_errors(const Training& training, const std::vector<double>& truth,
                                       const std::vector<Lookup>& lookups);
double log_error(const Training& training, const std::vector<double>& truth,
                 const std::vector<Lookup>& lookups);

// The pictures' views come first: how many there are.
int picture_views(const Training& training);

} // namespace gg::tables
