#include "tables/gaussian_fit.h"

#include <glm/gtc/quaternion.hpp>

#include <algorithm>
#include <cmath>
#include <random>

namespace gg::tables {
namespace {

// The share of the environment's geometric mean that residuals are taken above.
constexpr double floor_share = 0.2;

// A sample of the lobe stands for the solid angle 1 / density: it reads the map through a Gaussian of this share of its side.
// (A quarter more or less changes what the fits find by less than their own noise.)
constexpr double sample_width = 0.35;

glm::vec3 direction(double lean, double cos_theta) {
  const double sin_theta = std::sqrt((1.0 - cos_theta) * (1.0 + cos_theta));
  return glm::normalize(
      glm::vec3(glm::dvec3(-(1.0 - lean) * sin_theta, 0.0, (1.0 - lean) * cos_theta + lean)));
}

std::vector<double> residuals(const Training& training, const LobeRadiance& truth, double edge,
                              double cos_theta, const Tap& tap, std::size_t stride = 1) {
  const glm::vec3 local = direction(tap.lean, cos_theta);
  std::vector<double> r;
  r.reserve(training.views().size() / stride + 1);
  for (std::size_t v = 0; v < training.views().size(); v += stride) {
    const Training::View& view = training.views()[v];
    const SphereStack& stack = training.stack(view);
    const double floor = floor_share * stack.geometric_mean;
    const double read = stack.radiance(view.world_from_local * local, tap.sigma);
    r.push_back(std::log((read + floor) / (mixed(truth, v, edge) + floor)));
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

Training::Training(std::vector<SphereStack> stacks, int rotations_per_map, unsigned seed)
    : stacks_(std::move(stacks)) {
  std::mt19937 bits(seed);
  // Not std::normal_distribution, whose values differ between libraries: sums of uniform numbers are normal enough for
  // a direction in four dimensions to be uniform to within a few per cent.
  const auto normal = [&] {
    double sum = -6.0;
    for (int i = 0; i < 12; ++i)
      sum += static_cast<double>(bits()) * 0x1p-32;
    return static_cast<float>(sum);
  };
  for (int i = 0; i < static_cast<int>(stacks_.size()); ++i)
    for (int k = 0; k < rotations_per_map; ++k) {
      const float w = normal(), x = normal(), y = normal(), z = normal();
      views_.push_back({i, glm::mat3_cast(glm::normalize(glm::quat(w, x, y, z)))});
    }
}

LobeRadiance lobe_radiance(const Training& training, const std::vector<LobeSample>& lobe) {
  struct Read {
    glm::vec3 wi;
    float flat, edge;
    int level;
  };
  double flat_sum = 0.0, edge_sum = 0.0;
  for (const LobeSample& s : lobe) {
    flat_sum += s.weight;
    edge_sum += s.weight * std::pow(1.0 - s.cos_facet, 5.0);
  }
  const SphereStack& any =
      training.stack(training.views().front()); // all stacks have the same levels
  std::vector<Read> reads;
  for (const LobeSample& s : lobe)
    reads.push_back({glm::vec3(s.wi), static_cast<float>(s.weight / flat_sum),
                     static_cast<float>(s.weight * std::pow(1.0 - s.cos_facet, 5.0) / edge_sum),
                     any.nearest_level(sample_width / std::sqrt(s.density))});
  LobeRadiance result;
  for (const Training::View& view : training.views()) {
    const SphereStack& stack = training.stack(view);
    double flat = 0.0, edge = 0.0;
    for (const Read& read : reads) {
      const float light = stack.level(read.level).radiance(view.world_from_local * read.wi);
      flat += static_cast<double>(read.flat * light);
      edge += static_cast<double>(read.edge * light);
    }
    result.flat.push_back(flat);
    result.edge.push_back(edge);
  }
  return result;
}

double log_error(const Training& training, const LobeRadiance& truth, double edge, double cos_theta,
                 const Tap& tap) {
  const std::vector<double> r = residuals(training, truth, edge, cos_theta, tap);
  return std::sqrt(sum_of_squares(r) / static_cast<double>(r.size()));
}

Tap fit(const Training& training, const LobeRadiance& truth, double edge, double alpha,
        double cos_theta) {
  Tap best;
  double least = 1e300;
  for (double lean : {0.0, 0.01, 0.05, 0.15, 0.3, 0.5, 0.75, 0.95})
    for (double scale : {0.3, 0.5, 0.75, 1.0, 1.4, 1.9}) {
      const Tap tap{lean, scale * alpha};
      const double error = sum_of_squares(residuals(training, truth, edge, cos_theta, tap, 4));
      if (error < least) {
        least = error;
        best = tap;
      }
    }
  std::vector<double> r = residuals(training, truth, edge, cos_theta, best);
  least = sum_of_squares(r);
  double damping = 1e-3;
  for (int iteration = 0; iteration < 30 && damping < 1e4; ++iteration) {
    // Wide steps: bilinear lookups are only piecewise smooth.
    const double dl = 0.02 * std::max(best.lean, 0.02), ds = 0.03;
    const std::vector<double> rl =
        residuals(training, truth, edge, cos_theta, {best.lean + dl, best.sigma});
    const std::vector<double> rs =
        residuals(training, truth, edge, cos_theta, {best.lean, best.sigma * std::exp(ds)});
    double ll = 0, ls = 0, ss = 0, gl = 0, gs = 0;
    for (std::size_t i = 0; i < r.size(); ++i) {
      const double a = (rl[i] - r[i]) / dl, b = (rs[i] - r[i]) / ds;
      ll += a * a;
      ls += a * b;
      ss += b * b;
      gl += a * r[i];
      gs += b * r[i];
    }
    bool better = false;
    while (!better && damping < 1e4) {
      const double l = ll * (1 + damping) + 1e-9, s = ss * (1 + damping) + 1e-9,
                   det = l * s - ls * ls;
      const double step_l = -(s * gl - ls * gs) / det,
                   step_s = std::clamp(-(l * gs - ls * gl) / det, -0.5, 0.5);
      const Tap tap{std::clamp(best.lean + step_l, 0.0, 1.0),
                    std::min(best.sigma * std::exp(step_s), 1.25)};
      std::vector<double> trial = residuals(training, truth, edge, cos_theta, tap);
      const double error = sum_of_squares(trial);
      better = error < least;
      if (better) {
        const bool done = least - error < 1e-5 * least;
        least = error;
        best = tap;
        r = std::move(trial);
        damping *= 0.2;
        if (done) return best;
      } else {
        damping *= 5.0;
      }
    }
  }
  return best;
}

} // namespace gg::tables
