#include "tables/gaussian_fit.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <numbers>

namespace gg::tables {
namespace {

// Angles, ln sigma, and the logits of all weights but the first's.
constexpr int most_parameters = 3 * most_lobes - 1;
using Parameters = std::array<double, most_parameters>;
using Rows = std::vector<float>; // a number per view

// Steps of the derivatives, in widths and in ln sigma: wide ones, as bilinear lookups are only piecewise smooth.
constexpr double angle_step = 0.05, log_step = 0.05;
// Squared log error per squared parameter: moving a Gaussian by a third of the width to please a neighbour may cost 1e-5, half a
// per cent of what two Gaussians leave.
constexpr double pull = 1e-4;
// Beyond a weight of 1 in 50 a Gaussian has nothing left to say, and no place that is better than another.
constexpr double greatest_logit = 4.0;

// ln of a positive normal number, good to a float's rounding: x = 2^e m with m between the roots of 1/2 and 2, and
// ln m = 2 artanh s, s = (m - 1) / (m + 1), |s| < .172, whose series ends at s^9: the next term is 7e-10. Unlike std::log it
// takes four numbers at once; fits would spend half of their time there.
float natural_log(float x) {
  constexpr std::uint32_t root_of_half = 0x3f3504f3u;
  const auto bits = std::bit_cast<std::uint32_t>(x);
  const std::int32_t e = static_cast<std::int32_t>(bits - root_of_half) >> 23;
  const auto m = std::bit_cast<float>(bits - (static_cast<std::uint32_t>(e) << 23));
  const float s = (m - 1.0f) / (m + 1.0f), z = s * s;
  const float series =
      s * (2.0f + z * (2.0f / 3.0f + z * (0.4f + z * (2.0f / 7.0f + z * (2.0f / 9.0f)))));
  return static_cast<float>(e) * std::numbers::ln2_v<float> + series;
}

float dot(const Rows& a, const Rows& b) {
  float sum[4] = {}; // four sums that the compiler may keep in one register
  const std::size_t n = a.size() & ~std::size_t{3};
  for (std::size_t v = 0; v < n; v += 4)
    for (std::size_t lane = 0; lane < 4; ++lane)
      sum[lane] += a[v + lane] * b[v + lane];
  for (std::size_t v = n; v < a.size(); ++v)
    sum[0] += a[v] * b[v];
  return sum[0] + sum[1] + sum[2] + sum[3];
}

class Problem {
public:
  Problem(const FitViews& views, const FitTarget& target, int gaussians)
      : views_(views), target_(target), gaussians_(gaussians),
        n_(static_cast<std::size_t>(views.count())),
        reads_(static_cast<std::size_t>(gaussians), Rows(n_)) {}

  int parameters() const { return 3 * gaussians_ - 1; }
  int angle(int k) const { return k; }
  int width(int k) const { return gaussians_ + k; }
  int logit(int k) const { return 2 * gaussians_ + k - 1; } // k >= 1

  Parameters from(std::span<const Gaussian> set) const {
    Parameters p{};
    for (int k = 0; k < gaussians_; ++k) {
      const Gaussian& g = set[static_cast<std::size_t>(k)];
      at(p, angle(k)) = (g.angle - target_.lens.angle) / target_.width;
      at(p, width(k)) = std::log(g.sigma / target_.width);
      if (k > 0) at(p, logit(k)) = std::log(g.weight / set[0].weight);
    }
    return limited(p);
  }

  GaussianSum set(const Parameters& p) const {
    GaussianSum set;
    const std::array<double, most_lobes> w = weights(p);
    for (int k = 0; k < gaussians_; ++k)
      set.push_back({target_.lens.angle + at(p, angle(k)) * target_.width,
                     std::exp(at(p, width(k))) * target_.width, w[static_cast<std::size_t>(k)]});
    return set;
  }

  // Widths in order, angles not behind the surface by more than half a radian, weights that count.
  Parameters limited(Parameters p) const {
    constexpr double farthest = 0.5 * std::numbers::pi + 0.5;
    const double widest =
        std::log(FitViews::greatest_sigma / (target_.width * target_.lens.magnification));
    for (int k = 0; k < gaussians_; ++k) {
      double& a = at(p, angle(k));
      a = target_.symmetric
              ? -target_.lens.angle / target_.width
              : (std::clamp(target_.lens.angle + a * target_.width, -farthest, farthest)
                 - target_.lens.angle)
                    / target_.width;
      double& s = at(p, width(k));
      s = std::clamp(s, k == 0 ? -4.0 : at(p, width(k - 1)), widest);
      if (k > 0) at(p, logit(k)) = std::clamp(at(p, logit(k)), -greatest_logit, greatest_logit);
    }
    return p;
  }

  // Of every view; keeps the reads for derivatives().
  double residuals(const Parameters& p, Rows& r) {
    const std::array<double, most_lobes> w = weights(p);
    sum_.assign(n_, 0.0f);
    for (int k = 0; k < gaussians_; ++k) {
      Rows& read = reads_[static_cast<std::size_t>(k)];
      look(at(p, angle(k)), at(p, width(k)), read);
      const auto weight = static_cast<float>(w[static_cast<std::size_t>(k)]);
      for (std::size_t v = 0; v < n_; ++v)
        sum_[v] += weight * read[v];
    }
    r.resize(n_);
    const float* floors = views_.floors().data();
    const float* light = target_.radiance.data();
    for (std::size_t v = 0; v < n_; ++v)
      r[v] = natural_log((sum_[v] + floors[v]) / (light[v] + floors[v]));
    return static_cast<double>(dot(r, r)) / static_cast<double>(n_);
  }

  // At the p that residuals() was last called with.
  void derivatives(const Parameters& p, std::vector<Rows>& columns) {
    const std::array<double, most_lobes> w = weights(p);
    columns.resize(static_cast<std::size_t>(parameters()));
    Rows moved(n_);
    const auto column = [&](int i) -> Rows& {
      Rows& c = columns[static_cast<std::size_t>(i)];
      c.assign(n_, 0.0f);
      return c;
    };
    const auto difference = [&](Rows& c, const Rows& read, double scale) {
      const auto f = static_cast<float>(scale);
      for (std::size_t v = 0; v < n_; ++v)
        c[v] = f * (moved[v] - read[v]) / (sum_[v] + views_.floors()[v]);
    };
    for (int k = 0; k < gaussians_; ++k) {
      const double weight = w[static_cast<std::size_t>(k)];
      const Rows& read = reads_[static_cast<std::size_t>(k)];
      Rows& turned = column(angle(k));
      if (!target_.symmetric) {
        look(at(p, angle(k)) + angle_step, at(p, width(k)), moved);
        difference(turned, read, weight / angle_step);
      }
      look(at(p, angle(k)), at(p, width(k)) + log_step, moved);
      difference(column(width(k)), read, weight / log_step);
      if (k == 0) continue;
      Rows& c = column(logit(k));
      const auto f = static_cast<float>(weight);
      for (std::size_t v = 0; v < n_; ++v)
        c[v] = f * (read[v] - sum_[v]) / (sum_[v] + views_.floors()[v]);
    }
  }

private:
  static double& at(Parameters& p, int i) { return p[static_cast<std::size_t>(i)]; }
  static double at(const Parameters& p, int i) { return p[static_cast<std::size_t>(i)]; }

  std::array<double, most_lobes> weights(const Parameters& p) const {
    std::array<double, most_lobes> w{};
    double sum = 0.0;
    for (int k = 0; k < gaussians_; ++k)
      sum += w[static_cast<std::size_t>(k)] = k == 0 ? 1.0 : std::exp(at(p, logit(k)));
    for (double& x : w)
      x /= sum;
    return w;
  }
  void look(double angle, double log_width, Rows& read) const {
    const double unit = target_.width * target_.lens.magnification;
    views_.read(angle * unit, std::exp(log_width) * unit, read.data());
  }

  const FitViews& views_;
  const FitTarget& target_;
  int gaussians_;
  std::size_t n_;
  std::vector<Rows> reads_;
  Rows sum_;
};

// Solves the symmetric, positive definite system in place, by Cholesky's factors.
void solve(std::array<std::array<double, most_parameters>, most_parameters>& m, Parameters& b,
           std::size_t n) {
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j <= i; ++j) {
      double sum = m[i][j];
      for (std::size_t k = 0; k < j; ++k)
        sum -= m[i][k] * m[j][k];
      // A pivot that rounding has made negative: what double keeps of a sum of squares of about 1 is 1e-16.
      m[i][j] = i == j ? std::sqrt(std::max(sum, 1e-14)) : sum / m[j][j];
    }
    for (std::size_t k = 0; k < i; ++k)
      b[i] -= m[i][k] * b[k];
    b[i] /= m[i][i];
  }
  for (std::size_t i = n; i-- > 0;) {
    for (std::size_t k = i + 1; k < n; ++k)
      b[i] -= m[k][i] * b[k];
    b[i] /= m[i][i];
  }
}

double distance(const Parameters& a, const Parameters& b, std::size_t n) {
  double sum = 0.0;
  for (std::size_t i = 0; i < n; ++i)
    sum += (a[i] - b[i]) * (a[i] - b[i]);
  return sum;
}

} // namespace

FitTarget fit_target(const FitViews& views, const std::vector<LobeSample>& lobe,
                     const std::vector<double>& weights, bool symmetric) {
  LobeShape shape = shape_of(lobe);
  if (symmetric) shape.angle = 0.0;
  FitTarget target;
  target.lens = lens_for(shape);
  target.width = shape.width;
  target.symmetric = symmetric;
  target.radiance = views.radiance(views.pixels(lobe, weights, target.lens));
  return target;
}

double log_error(const FitViews& views, const FitTarget& target, const GaussianSum& gaussians) {
  Problem problem(views, target, static_cast<int>(gaussians.size()));
  Rows r;
  return std::sqrt(problem.residuals(problem.from(gaussians), r));
}

FitResult fit(const FitViews& views, const FitTarget& target, const GaussianSum& start,
              int iterations, std::span<const Gaussian> towards) {
  Problem problem(views, target, static_cast<int>(start.size()));
  const auto n = static_cast<std::size_t>(problem.parameters());
  const bool pulled = !towards.empty();
  const Parameters home = pulled ? problem.from(towards) : Parameters{};
  Parameters p = problem.from(start);
  Rows r, trial;
  std::vector<Rows> columns;
  double error = problem.residuals(p, r);
  double cost = error + (pulled ? pull * distance(p, home, n) : 0.0);
  // Levenberg-Marquardt: a mild start; it is lowered at each success and raised at each failure.
  double damping = 1e-2;
  for (int iteration = 0; iteration < iterations && damping < 1e5; ++iteration) {
    if (iteration > 0) problem.residuals(p, r); // a refused step has moved the reads
    problem.derivatives(p, columns);
    std::array<std::array<double, most_parameters>, most_parameters> normal{};
    Parameters slope{};
    const double views_inverse = 1.0 / static_cast<double>(r.size());
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = 0; j <= i; ++j)
        normal[i][j] = static_cast<double>(dot(columns[i], columns[j])) * views_inverse;
      slope[i] = -static_cast<double>(dot(columns[i], r)) * views_inverse
                 - (pulled ? pull * (p[i] - home[i]) : 0.0);
      if (pulled) normal[i][i] += pull;
    }
    bool better = false, done = false;
    while (!better && damping < 1e5) {
      auto m = normal;
      for (std::size_t i = 0; i < n; ++i)
        // A parameter without effect stays where it is.
        m[i][i] += damping * normal[i][i] + 1e-9;
      Parameters step = slope;
      solve(m, step, n);
      Parameters q = p;
      for (std::size_t i = 0; i < n; ++i)
        q[i] += std::clamp(step[i], -0.7, 0.7);
      q = problem.limited(q);
      const double trial_error = problem.residuals(q, trial);
      const double trial_cost = trial_error + (pulled ? pull * distance(q, home, n) : 0.0);
      better = trial_cost < cost;
      if (better) {
        // A thousandth less error is less than another start of the search changes.
        done = cost - trial_cost < 1e-3 * cost;
        cost = trial_cost;
        error = trial_error;
        p = q;
        damping *= 0.2;
      } else {
        damping *= 6.0;
      }
    }
    if (done) break;
  }
  return {problem.set(p), std::sqrt(error), cost};
}

FitResult fit_from_scratch(const FitViews& views, const FitTarget& target, int gaussians,
                           int iterations) {
  // {angle, sigma, weight} in widths: a core with tails about it, a row along the plane of incidence, a row with a tail.
  static const std::vector<GaussianSum> starts[most_lobes] = {
      {{{0, 0.8, 1}}},
      {{{0, 0.5, 0.6}, {0, 1.5, 0.4}}, {{-0.4, 0.6, 0.5}, {0.6, 0.8, 0.5}}},
      {{{0, 0.4, 0.4}, {0, 0.8, 0.4}, {0, 2.0, 0.2}},
       {{-0.6, 0.5, 0.35}, {0.2, 0.55, 0.4}, {1.2, 1.0, 0.25}},
       {{-0.4, 0.5, 0.4}, {0.6, 0.6, 0.4}, {0, 2.0, 0.2}}},
      {{{0, 0.35, 0.3}, {0, 0.6, 0.3}, {0, 1.2, 0.25}, {0, 2.4, 0.15}},
       {{-0.8, 0.4, 0.3}, {0, 0.5, 0.3}, {0.8, 0.6, 0.25}, {1.5, 1.2, 0.15}},
       {{-0.5, 0.3, 0.3}, {0.2, 0.35, 0.3}, {1.0, 0.7, 0.25}, {0, 2.4, 0.15}}}};
  FitResult best;
  best.error = 1e300;
  for (GaussianSum start : starts[gaussians - 1]) {
    for (Gaussian& g : start) {
      g.angle = target.lens.angle + g.angle * target.width;
      g.sigma *= target.width;
    }
    FitResult result = fit(views, target, start, iterations);
    if (result.error < best.error) best = std::move(result);
  }
  return best;
}

} // namespace gg::tables
