#include "tables/fit_views.h"

#include "core/progress.h"
#include "tables/training.h"
#include "tables/training_maps.h"

#include <glm/mat3x3.hpp>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gg::tables {
namespace {

constexpr double pi = std::numbers::pi;

// The share of the environment's geometric mean that residuals are taken above.
constexpr double floor_share = 0.2;

// A lobe's median angle is magnified to this, if it is smaller: 6 times the blur of the finest level.
constexpr double least_width = 0.12;

// The finest level that is read: level 0 of the stacks is their sharp map, whose texels a single read would miss.
constexpr int first_level = 1;

// Rings and azimuths lie this many to a level's sigma apart, points of the circle that many.
constexpr double per_sigma = 1.5, circle_per_sigma = 4.0;

// A sample of the lobe stands for the solid angle 1 / density: it reads the map through a Gaussian of this share of its side.
// A row of Gaussians that far apart, a lamp seen through it, is even to 2 exp(-2 pi² 0.7²) = 1e-4 per axis (0.35 would
// leave 18 %), and what it adds to the lobe's variance is 3 / count of it.
constexpr double sample_width = 0.7;

} // namespace

Lens lens_for(const LobeShape& shape) {
  return {shape.angle, shape.width > 0.0 ? std::max(least_width / shape.width, 1.0) : 1.0};
}

FitViews::FitViews(const std::vector<SphereStack>& stacks, int rotations_per_map, unsigned seed)
    : count_(rotations_per_map * static_cast<int>(stacks.size())) {
  const std::vector<glm::mat3> turn = random_rotations(count_, seed);
  const auto stack_of = [&](std::size_t view) -> const SphereStack& {
    return stacks[view / static_cast<std::size_t>(rotations_per_map)];
  };
  for (std::size_t v = 0; v < stride(); ++v)
    floors_.push_back(static_cast<float>(floor_share * stack_of(v).geometric_mean));

  struct Place {
    int level;
    glm::vec3 a, b; // mirrored sides
  };
  std::vector<Place> pixel_places, circle_places;
  const auto at = [](double angle, double azimuth) {
    return glm::vec3(glm::dvec3(std::sin(angle) * std::cos(azimuth),
                                std::sin(angle) * std::sin(azimuth), std::cos(angle)));
  };
  for (int k = first_level; k < stacks.front().level_count(); ++k) {
    Level level;
    level.sigma = stacks.front().sigma(k);
    const int rings = static_cast<int>(std::ceil(pi * per_sigma / level.sigma));
    level.spacing = pi / rings;
    for (int i = 0; i < rings; ++i) {
      const double angle = (i + 0.5) * level.spacing;
      level.first.push_back(static_cast<int>(pixel_places.size()));
      level.length.push_back(static_cast<int>(std::ceil(pi * std::sin(angle) / level.spacing)));
      for (int j = 0; j < level.length.back(); ++j) {
        const double azimuth = pi * (j + 0.5) / level.length.back();
        pixel_places.push_back({k, at(angle, azimuth), at(angle, -azimuth)});
      }
    }
    level.circle_first = static_cast<int>(circle_places.size());
    level.circle_length = static_cast<int>(std::ceil(2.0 * pi * circle_per_sigma / level.sigma));
    for (int i = 0; i < level.circle_length; ++i) {
      const glm::vec3 d = at(2.0 * pi * i / level.circle_length, 0.0);
      circle_places.push_back({k, d, d});
    }
    levels_.push_back(level);
  }
  const auto fill = [&](const std::vector<Place>& places, std::vector<float>& values) {
    values.resize(places.size() * stride());
    tbb::parallel_for(std::size_t{0}, places.size(), [&](std::size_t p) {
      for (std::size_t v = 0; v < stride(); ++v) {
        const SphereMap& map = stack_of(v).level(places[p].level);
        values[p * stride() + v] =
            0.5f * (map.radiance(turn[v] * places[p].a) + map.radiance(turn[v] * places[p].b));
      }
    });
  };
  fill(pixel_places, pixels_);
  fill(circle_places, circles_);
}

PixelSum FitViews::pixels(const std::vector<LobeSample>& lobe, const std::vector<double>& weights,
                          const Lens& lens) const {
  double total = 0.0;
  for (double w : weights)
    total += w;
  std::vector<PixelSum::Term> all;
  const glm::dvec3 axis(std::sin(lens.angle), 0.0, std::cos(lens.angle)),
      along(axis.z, 0.0, -axis.x);
  const double base = levels_.front().sigma;
  for (std::size_t s = 0; s < lobe.size(); ++s) {
    const glm::dvec3 d(-lobe[s].wi.x, lobe[s].wi.y, std::abs(lobe[s].wi.z));
    const double angle = 2.0 * std::asin(std::min(0.5 * glm::length(d - axis), 1.0));
    const double azimuth = std::atan2(std::abs(d.y), glm::dot(d, along));
    const double seen = std::min(lens.magnification * angle, pi);
    // Solid angles grow by the lens in both directions.
    // On the axis sin / sin is the magnification.
    const double growth = angle > 1e-9
                              ? lens.magnification * std::sin(std::min(seen, 3.0)) / std::sin(angle)
                              : lens.magnification * lens.magnification;
    const double spread = sample_width * std::sqrt(std::max(growth, 0.0) / lobe[s].density);
    const double step = 2.0 * std::log2(std::hypot(base, spread) / base);
    const Level& level = levels_[static_cast<std::size_t>(
        std::clamp(static_cast<int>(std::lround(step)), 0, static_cast<int>(levels_.size()) - 1))];
    // Between the two rings and the two azimuths in each that are nearest.
    const int rings = static_cast<int>(level.first.size());
    const double ring = std::clamp(seen / level.spacing - 0.5, 0.0, rings - 1.0);
    const int low = std::min(static_cast<int>(ring), rings - 2);
    for (int r = low; r <= low + 1; ++r) {
      const double share = 1.0 - std::abs(ring - r);
      const int length = level.length[static_cast<std::size_t>(r)];
      const double column = std::clamp(azimuth / pi * length - 0.5, 0.0, length - 1.0);
      const int left = static_cast<int>(column), right = std::min(left + 1, length - 1);
      const double w = share * weights[s] / total, f = column - left;
      const int first = level.first[static_cast<std::size_t>(r)];
      all.push_back({first + left, static_cast<float>(w * (1.0 - f))});
      all.push_back({first + right, static_cast<float>(w * f)});
    }
  }
  std::ranges::sort(all, {}, &PixelSum::Term::pixel);
  PixelSum sum;
  for (const PixelSum::Term& term : all)
    if (!sum.terms.empty() && sum.terms.back().pixel == term.pixel)
      sum.terms.back().weight += term.weight;
    else if (term.weight > 0.0f)
      sum.terms.push_back(term);
  return sum;
}

std::vector<float> FitViews::radiance(const PixelSum& lobe) const {
  std::vector<float> result(stride(), 0.0f);
  for (const PixelSum::Term& term : lobe.terms) {
    const float* from = pixel(term.pixel);
    const float w = term.weight;
    for (std::size_t v = 0; v < stride(); ++v)
      result[v] += w * from[v];
  }
  return result;
}

void FitViews::read(double angle, double sigma, float* result) const {
  // The maps are level 0's for the lobe and for its Gaussians: its blur adds to both.
  const double base = levels_.front().sigma, limited = std::min(sigma, greatest_sigma);
  const double variance = limited * limited + base * base;
  const int low =
      std::clamp(static_cast<int>(std::floor(std::log2(variance / (base * base)) + 1e-12)), 0,
                 static_cast<int>(levels_.size()) - 2);
  const auto low_index = static_cast<std::size_t>(low);
  const double below = levels_[low_index].sigma * levels_[low_index].sigma,
               above = levels_[low_index + 1].sigma * levels_[low_index + 1].sigma;
  const double up = std::clamp((variance - below) / (above - below), 0.0, 1.0);
  const float* from[4];
  float weight[4];
  for (std::size_t k = 0; k < 2; ++k) {
    const Level& level = levels_[low_index + k];
    const double turns = angle / (2.0 * pi);
    const double position = (turns - std::floor(turns)) * level.circle_length;
    const int left = std::min(static_cast<int>(position), level.circle_length - 1);
    const double f = position - left, share = k == 0 ? 1.0 - up : up;
    from[2 * k] = circle(level, left);
    from[2 * k + 1] = circle(level, (left + 1) % level.circle_length);
    weight[2 * k] = static_cast<float>(share * (1.0 - f));
    weight[2 * k + 1] = static_cast<float>(share * f);
  }
  for (std::size_t v = 0; v < stride(); ++v)
    result[v] = weight[0] * from[0][v] + weight[1] * from[1][v] + weight[2] * from[2][v]
                + weight[3] * from[3][v];
}

FitViews make_fit_views(Progress* progress) {
  constexpr int map_size = 128, rotations_per_map = 64;
  constexpr unsigned seed = 1;
  std::vector<SphereMap> maps;
  if (progress) progress->update(0, "painting environments");
  for (int draw : fitted_draws)
    for (const TrainingMap& map : training_maps(map_size, draw))
      maps.push_back(map.map);
  if (progress) progress->update(0, "blurring environments");
  return FitViews(stacks_of(maps), rotations_per_map, seed);
}

} // namespace gg::tables
