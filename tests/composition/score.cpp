#include "composition/score.h"

#include "tables/training_maps.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace gg::composition_test {
namespace {

// As in app/tables/gaussian_fit.cpp: relative error where there is light, blind to the darkest.
constexpr double floor_share = 0.2;

// Paths are read through a Gaussian of this share of the lobe's median radius: it smooths what 10^4 paths leave of a sharp
// map's noise, and adds half a per cent to the width.
constexpr double smoothing = 0.1;

std::vector<double> residuals(const std::vector<double>& truth_seen,
                              const std::vector<Lookup>& lobes, double energy) {
  std::vector<double> r;
  r.reserve(truth_seen.size());
  for (std::size_t v = 0; v < truth_seen.size(); ++v) {
    const auto& view = environments().views()[v];
    const tables::SphereStack& stack = environments().stack(view);
    double sum = 0.0;
    for (const Lookup& lobe : lobes)
      if (lobe.weight > 0.0)
        sum += lobe.weight
               * static_cast<double>(
                   stack.radiance(view.world_from_local * glm::vec3(lobe.direction), lobe.sigma));
    const double floor = floor_share * stack.geometric_mean;
    r.push_back(std::log((sum / energy + floor) / (truth_seen[v] + floor)));
  }
  return r;
}

double sum_of_squares(const std::vector<double>& r) {
  double sum = 0.0;
  for (double x : r)
    sum += x * x;
  return sum;
}

} // namespace

double energy_of(const std::vector<Lookup>& lobes) {
  double sum = 0.0;
  for (const Lookup& lobe : lobes)
    sum += lobe.weight;
  return sum;
}

const tables::Training& environments(int texels_per_edge) {
  static const tables::Training training = [texels_per_edge] {
    std::vector<tables::SphereMap> maps;
    for (int draw : tables::held_out_draws)
      for (const tables::TrainingMap& map : tables::training_maps(texels_per_edge, draw))
        maps.push_back(map.map);
    return tables::Training(tables::stacks_of(maps), 24, 3);
  }();
  return training;
}

std::vector<double> seen(const Truth& truth) {
  std::vector<double> result;
  if (!(truth.energy > 0.0)) return result;
  const auto& training = environments();
  const int level =
      training.stack(training.views().front()).nearest_level(smoothing * truth.spread);
  for (const auto& view : training.views()) {
    const tables::SphereMap& map = training.stack(view).level(level);
    double sum = 0.0;
    for (const Path& path : truth.paths)
      sum +=
          static_cast<double>(path.weight * map.radiance(view.world_from_local * path.direction));
    result.push_back(sum / truth.energy);
  }
  return result;
}

Score score(const Truth& truth, const std::vector<double>& truth_seen,
            const std::vector<Lookup>& lobes) {
  const auto rms = [&](double energy) {
    return std::sqrt(sum_of_squares(residuals(truth_seen, lobes, energy))
                     / static_cast<double>(truth_seen.size()));
  };
  // Nothing at all, if that is the answer, is scored as black.
  const double energy = std::max(energy_of(lobes), 1e-6);
  return {rms(truth.energy), rms(energy)};
}

std::vector<Lookup> fitted(const Truth& truth, const std::vector<double>& truth_seen,
                           std::vector<Lookup> start) {
  // Per lobe: two turns, ln sigma, ln weight.
  const std::size_t count = 4 * start.size();
  const auto moved = [&](const std::vector<Lookup>& from, const std::vector<double>& step) {
    std::vector<Lookup> to = from;
    for (std::size_t i = 0; i < to.size(); ++i) {
      Lookup& lobe = to[i];
      const glm::dvec3 side =
          std::abs(lobe.direction.y) < 0.9 ? glm::dvec3(0, 1, 0) : glm::dvec3(1, 0, 0);
      const glm::dvec3 x = normalize(cross(side, lobe.direction)), y = cross(lobe.direction, x);
      lobe.direction = normalize(lobe.direction + step[4 * i] * x + step[4 * i + 1] * y);
      lobe.sigma =
          std::clamp(lobe.sigma * std::exp(std::clamp(step[4 * i + 2], -0.5, 0.5)), 1e-4, 1.25);
      lobe.weight *= std::exp(std::clamp(step[4 * i + 3], -1.0, 1.0));
    }
    const double scale = truth.energy / energy_of(to);
    for (Lookup& lobe : to)
      lobe.weight *= scale;
    return to;
  };
  for (Lookup& lobe : start) {
    lobe.weight = std::max(lobe.weight, 0.02 * truth.energy);
    lobe.sigma = std::max(lobe.sigma, 1e-3);
  }
  start = moved(start, std::vector<double>(count, 0.0));
  const auto residual = [&](const std::vector<Lookup>& lobes) {
    return residuals(truth_seen, lobes, truth.energy);
  };
  std::vector<double> r = residual(start);
  double least = sum_of_squares(r), damping = 1e-2;
  for (int iteration = 0; iteration < 40 && damping < 1e5; ++iteration) {
    std::vector<std::vector<double>> slope(count);
    for (std::size_t k = 0; k < count; ++k) {
      std::vector<double> step(count, 0.0);
      step[k] = k % 4 < 2 ? 0.1 * start[k / 4].sigma : 0.02;
      slope[k] = residual(moved(start, step));
      for (std::size_t v = 0; v < r.size(); ++v)
        slope[k][v] = (slope[k][v] - r[v]) / step[k];
    }
    std::vector<std::vector<double>> m(count, std::vector<double>(count + 1, 0.0));
    for (std::size_t a = 0; a < count; ++a) {
      for (std::size_t v = 0; v < r.size(); ++v) {
        for (std::size_t b = 0; b < count; ++b)
          m[a][b] += slope[a][v] * slope[b][v];
        m[a][count] -= slope[a][v] * r[v];
      }
      m[a][a] = m[a][a] * (1.0 + damping) + 1e-9;
    }
    for (std::size_t a = 0; a < count; ++a)
      for (std::size_t b = 0; b < count; ++b) {
        if (a == b) continue;
        const double f = m[b][a] / m[a][a];
        for (std::size_t c = a; c <= count; ++c)
          m[b][c] -= f * m[a][c];
      }
    std::vector<double> step(count);
    for (std::size_t a = 0; a < count; ++a)
      step[a] = m[a][count] / m[a][a];
    const std::vector<Lookup> trial = moved(start, step);
    const std::vector<double> trial_r = residual(trial);
    const double error = sum_of_squares(trial_r);
    if (error < least) {
      const bool done = least - error < 1e-4 * least;
      start = trial;
      r = trial_r;
      least = error;
      damping *= 0.3;
      if (done) break;
    } else {
      damping *= 5.0;
    }
  }
  return start;
}

} // namespace gg::composition_test
