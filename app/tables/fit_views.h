// Environments in many orientations, laid out so that a lobe or a Gaussian is read in all of them at once: what the fits
// spend their time on.
#pragma once

#include "tables/lobe.h"
#include "tables/sphere_map.h"

#include <array>
#include <vector>

namespace gg {
class Progress;
}

namespace gg::tables {

// The frame that a lobe is fitted in. Its centre lies at `angle` in the plane of incidence (LobeShape), and a lens about it
// magnifies all angles so that even the narrowest lobe is as wide as details of the maps: natural light has detail at every
// scale alike, and the maps then need no finer levels than the fits read.
struct Lens {
  double angle = 0.0, magnification = 1.0;
};
Lens lens_for(const LobeShape& shape);

// A lobe as sums of pixels, as FitViews keeps them.
struct PixelSum {
  struct Term {
    int pixel = 0;
    float weight = 0.0f;
  };
  std::vector<Term> terms;
};

class FitViews {
public:
  FitViews(const std::vector<SphereStack>& stacks, int rotations_per_map, unsigned seed);

  int count() const { return count_; }
  // A fifth of the geometric mean of each view's map: what errors are relative to, where there is less light than that.
  const std::vector<float>& floors() const { return floors_; }

  // The lobe through the lens; `weights` (as many as samples) are divided by their sum. Samples spread over the solid angle
  // that they stand for.
  PixelSum pixels(const std::vector<LobeSample>& lobe, const std::vector<double>& weights,
                  const Lens& lens) const;
  // Its radiance in every view.
  std::vector<float> radiance(const PixelSum& lobe) const;

  // A Gaussian's radiance in every view, into `result`, at an angle from the lens's axis in the plane of incidence;
  // both magnified, radians.
  void read(double angle, double sigma, float* result) const;
  static constexpr double greatest_sigma = 1.25; // the stacks end a little beyond

private:
  // Pixels of a hemisphere's half: rings about the lens's axis, each with azimuths from 0 to π. The lobe is symmetric, so
  // each pixel holds the mean of both sides of the plane of incidence.
  struct Level {
    double sigma = 0.0;      // of the map that is read, blur of level 0 included
    double spacing = 0.0;    // between rings
    std::vector<int> first;  // of each ring, in pixels of all levels
    std::vector<int> length; // of each ring
    int circle_first = 0, circle_length = 0;
  };
  float* pixel(int index) { return &pixels_[static_cast<std::size_t>(index) * stride()]; }
  const float* pixel(int index) const {
    return &pixels_[static_cast<std::size_t>(index) * stride()];
  }
  const float* circle(const Level& level, int index) const {
    return &circles_[static_cast<std::size_t>(level.circle_first + index) * stride()];
  }
  std::size_t stride() const { return static_cast<std::size_t>(count_); }

  int count_ = 0;
  std::vector<float> floors_;
  std::vector<Level> levels_;
  std::vector<float> pixels_;  // [pixel][view]
  std::vector<float> circles_; // [level, angle][view]: the plane of incidence, all around
};

// The maps and orientations that the tables are fitted on.
FitViews make_fit_views(Progress* progress);

} // namespace gg::tables
