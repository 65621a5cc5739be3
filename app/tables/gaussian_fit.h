// Sums of Gaussians fitted to a lobe: which directions, widths and weights make K lookups in a Gaussian stack come closest to
// the integral of the lobe over an environment.
#pragma once

#include "tables/fit_views.h"

#include <span>
#include <vector>

namespace gg::tables {

inline constexpr int most_lobes = 4;

// One lookup: angle in the plane of incidence (LobeShape), sigma in radians. The weights of a set sum to 1, widths grow.
struct Gaussian {
  double angle = 0.0, sigma = 0.0, weight = 1.0;
};
using GaussianSum = std::vector<Gaussian>;

// What a fit aims at.
struct FitTarget {
  std::vector<float> radiance; // of the lobe in every view
  Lens lens;
  double width = 0.0;     // radians, unmagnified: the unit that angles and widths vary in
  bool symmetric = false; // seen along the normal: every angle is 0
};
// From a lobe that has samples.
FitTarget fit_target(const FitViews& views, const std::vector<LobeSample>& lobe,
                     const std::vector<double>& weights, bool symmetric);

struct FitResult {
  GaussianSum gaussians;
  double error =
      0.0; // root mean square over the views of ln((gaussians + f) / (lobe + f)), f the view's floor
  double cost = 0.0; // its square and the pull
};

double log_error(const FitViews& views, const FitTarget& target, const GaussianSum& gaussians);

// The nearest minimum from `start` by Levenberg and Marquardt's method on (angle, ln sigma, logits of the weights). Where
// `towards` is not empty (as many gaussians), a weak pull prefers it among the nearly as good.
FitResult fit(const FitViews& views, const FitTarget& target, const GaussianSum& start,
              int iterations, std::span<const Gaussian> towards = {});

// The best of several starts that know nothing but the lobe's place and width.
FitResult fit_from_scratch(const FitViews& views, const FitTarget& target, int gaussians,
                           int iterations);

} // namespace gg::tables
