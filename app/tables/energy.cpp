#include "tables/energy.h"

#include "glsl/f64.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace gg::tables {
namespace {

namespace glsl = gg::glsl::f64;

constexpr int bin_count =
    400; // of width 1/400: (width²/24) F'' is below 5e-6 even for Schlick's edge

using Parameters = std::array<double, 3>; // cos1, cos2, share1

double mean_of(const Parameters& p, const Reflectance& f) {
  return p[2] * f.at(p[0]) + (1.0 - p[2]) * f.at(p[1]);
}

// Relative errors, softened below 2 % of the light so that a reflectance near 0 does not rule.
std::vector<double> residuals(const Parameters& p, const std::vector<double>& exact) {
  std::vector<double> r;
  for (std::size_t i = 0; i < exact.size(); ++i)
    r.push_back((mean_of(p, reflectances()[i]) - exact[i]) / (exact[i] + 0.02));
  return r;
}

double sum_of_squares(const std::vector<double>& r) {
  double sum = 0.0;
  for (double x : r)
    sum += x * x;
  return sum;
}

// Solves the damped normal equations of Levenberg and Marquardt's step by elimination.
Parameters step(const std::vector<double>& r, const std::array<std::vector<double>, 3>& slope,
                double damping) {
  double m[3][4] = {};
  for (std::size_t a = 0; a < 3; ++a) {
    for (std::size_t i = 0; i < r.size(); ++i) {
      for (std::size_t b = 0; b < 3; ++b)
        m[a][b] += slope[a][i] * slope[b][i];
      m[a][3] -= slope[a][i] * r[i];
    }
    m[a][a] = m[a][a] * (1.0 + damping) + 1e-12; // a parameter without effect stays where it is
  }
  for (int a = 0; a < 3; ++a)
    for (int b = 0; b < 3; ++b) {
      if (b == a) continue;
      const double f = m[b][a] / m[a][a];
      for (int c = 0; c < 4; ++c)
        m[b][c] -= f * m[a][c];
    }
  return {m[0][3] / m[0][0], m[1][3] / m[1][1], m[2][3] / m[2][2]};
}

} // namespace

FacetAngles::FacetAngles(const std::vector<LobeSample>& lobe) : bins_(bin_count) {
  for (const LobeSample& s : lobe) {
    Bin& bin =
        bins_[static_cast<std::size_t>(std::clamp(s.cos_facet * bin_count, 0.0, bin_count - 1.0))];
    bin.weight += s.weight;
    bin.cos += s.weight * s.cos_facet;
  }
  double first = 0.0, second = 0.0;
  for (Bin& bin : bins_) {
    if (bin.weight > 0.0) bin.cos /= bin.weight;
    albedo_ += bin.weight;
    first += bin.weight * bin.cos;
    second += bin.weight * bin.cos * bin.cos;
  }
  mean_ = first / albedo_;
  deviation_ = std::sqrt(std::max(second / albedo_ - mean_ * mean_, 0.0));
}

double FacetAngles::integral(const std::function<double(double)>& reflectance) const {
  double sum = 0.0;
  for (const Bin& bin : bins_)
    if (bin.weight > 0.0) sum += bin.weight * reflectance(bin.cos);
  return sum;
}

const std::vector<Reflectance>& reflectances() {
  static const std::vector<Reflectance> list = [] {
    std::vector<Reflectance> all{
        {"Schlick's edge", [](double c) { return glsl::schlickWeight(c); }}};
    for (double eta : {1.1, 1.33, 1.5, 1.8, 2.42})
      all.push_back({"index " + std::to_string(eta).substr(0, 4),
                     [eta](double c) { return glsl::fresnelDielectricAt(c, eta); }});
    // Near the extremes of the metals in use: by channel, not by name, as only n and k matter.
    for (const auto& [n, k] :
         {std::pair{0.18, 3.42}, {1.33, 1.85}, {1.3, 7.5}, {3.1, 3.3}, {2.5, 3.3}, {3.6, 2.7}})
      all.push_back(
          {"metal n " + std::to_string(n).substr(0, 4) + " k " + std::to_string(k).substr(0, 4),
           [n, k](double c) { return glsl::fresnelConductor(c, n, k); }});
    return all;
  }();
  return list;
}

EnergyCell fit_energy(const Model& model, double alpha, double cos_theta, int count) {
  if (!(alpha > 0.0)) return {1.0, cos_theta, cos_theta, 0.5}; // a mirror
  const FacetAngles angles(reflection_lobe(model, alpha, cos_theta, Walk::grid, count));
  std::vector<double> exact;
  for (const Reflectance& f : reflectances())
    exact.push_back(angles.integral(f.at) / angles.albedo());

  // From Gauss's two points for the mean and the deviation.
  Parameters p{std::max(angles.mean() - angles.deviation(), 0.0),
               std::min(angles.mean() + angles.deviation(), 1.0), 0.5};
  std::vector<double> r = residuals(p, exact);
  double least = sum_of_squares(r);
  // Levenberg-Marquardt: a mild start; it is lowered at each success and raised at each failure.
  double damping = 1e-2;
  for (int iteration = 0; iteration < 100 && damping < 1e6; ++iteration) {
    std::array<std::vector<double>, 3> slope;
    for (std::size_t a = 0; a < 3; ++a) {
      Parameters q = p;
      // Inwards from the ends; far above what rounding adds, far below what residuals bend over.
      const double h = q[a] > 0.5 ? -1e-5 : 1e-5;
      q[a] += h;
      slope[a] = residuals(q, exact);
      for (std::size_t i = 0; i < r.size(); ++i)
        slope[a][i] = (slope[a][i] - r[i]) / h;
    }
    const Parameters s = step(r, slope, damping);
    Parameters q = p;
    for (std::size_t a = 0; a < 3; ++a)
      q[a] = std::clamp(p[a] + s[a], 0.0, 1.0);
    std::vector<double> trial = residuals(q, exact);
    const double error = sum_of_squares(trial);
    if (error < least) {
      // A millionth less error is none.
      const bool done = least - error < 1e-6 * least;
      p = q;
      r = std::move(trial);
      least = error;
      damping *= 0.3;
      if (done) break;
    } else {
      damping *= 4.0;
    }
  }
  if (p[0] > p[1]) return {angles.albedo(), p[1], p[0], 1.0 - p[2]};
  return {angles.albedo(), p[0], p[1], p[2]};
}

} // namespace gg::tables
