#include "neighbours/quadrature.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gg::neighbours_test {
namespace {

constexpr double pi = std::numbers::pi;
constexpr int kernel_steps = 720, polar_steps = 80, azimuth_steps = 120, cosine_steps = 160;
constexpr double whole = 5.0; // sigmas: beyond them lies a 300,000th

int terms_of(double sigma) {
  return std::min(2000, static_cast<int>(8.0 / sigma) + 8);
}

glm::dmat3 frame_about(const dvec3& d) {
  const dvec3 x =
      glm::normalize(glm::cross(std::abs(d.x) < 0.9 ? dvec3(1, 0, 0) : dvec3(0, 1, 0), d));
  return {x, glm::cross(d, x), d};
}

} // namespace

HeatKernel::HeatKernel(double sigma) {
  for (int i = 0; i <= kernel_steps; ++i) {
    const double w = std::cos(pi * i / kernel_steps);
    double before = 1.0, p = w, sum = 1.0;
    for (int l = 1; l <= terms_of(sigma); ++l) {
      sum += (2 * l + 1) * std::exp(-0.5 * l * (l + 1) * sigma * sigma) * p;
      const double next = ((2 * l + 1) * w * p - l * before) / (l + 1);
      before = p;
      p = next;
    }
    values_.push_back(std::max(sum, 0.0) / (4.0 * pi));
  }
}

double HeatKernel::at(double theta) const {
  const double x = theta / pi * kernel_steps;
  const std::size_t i = std::min(static_cast<std::size_t>(x), values_.size() - 2);
  return std::lerp(values_[i], values_[i + 1], x - static_cast<double>(i));
}

double cap_share(double sigma, double rho, double theta) {
  // Of the cap's indicator the l-th coefficient is (P_{l-1}(cos rho) - P_{l+1}(cos rho)) / 2.
  const double z = std::cos(rho), w = std::cos(theta);
  double sum = 0.5 * (1.0 - z), z_before = 1.0, z_p = z, w_before = 1.0, w_p = w;
  for (int l = 1; l <= terms_of(sigma); ++l) {
    const double z_next = ((2 * l + 1) * z * z_p - l * z_before) / (l + 1);
    sum += std::exp(-0.5 * l * (l + 1) * sigma * sigma) * 0.5 * (z_before - z_next) * w_p;
    const double w_next = ((2 * l + 1) * w * w_p - l * w_before) / (l + 1);
    z_before = z_p;
    z_p = z_next;
    w_before = w_p;
    w_p = w_next;
  }
  return sum;
}

double share_of(const HeatKernel& kernel, double sigma, const dvec3& direction,
                const std::function<bool(const dvec3&)>& is_met) {
  const glm::dmat3 frame = frame_about(direction);
  const double end = std::min(pi, whole * sigma);
  double met = 0.0, all = 0.0;
  for (int i = 0; i < polar_steps; ++i) {
    const double theta = (i + 0.5) * end / polar_steps;
    const double weight = kernel.at(theta) * std::sin(theta);
    for (int j = 0; j < azimuth_steps; ++j) {
      const double phi = 2.0 * pi * (j + 0.5 * (i & 1) + 0.25) / azimuth_steps;
      all += weight;
      if (is_met(frame
                 * dvec3(std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi),
                         std::cos(theta))))
        met += weight;
    }
  }
  return met / all;
}

double cosine_share_of(const dvec3& n, const std::function<bool(const dvec3&)>& is_met) {
  // Even in sin², where the weight is constant.
  const glm::dmat3 frame = frame_about(n);
  int met = 0;
  for (int i = 0; i < cosine_steps; ++i) {
    const double sine = std::sqrt((i + 0.5) / cosine_steps);
    for (int j = 0; j < cosine_steps; ++j) {
      const double phi = 2.0 * pi * (j + 0.618034 * i) / cosine_steps;
      met += is_met(
          frame * dvec3(sine * std::cos(phi), sine * std::sin(phi), std::sqrt(1.0 - sine * sine)));
    }
  }
  return static_cast<double>(met) / (cosine_steps * cosine_steps);
}

bool meets_rectangle(const dvec3& ray, const dvec3& centre, const dvec3& u, const dvec3& v) {
  const dvec3 n = glm::cross(u, v);
  const double distance = glm::dot(centre, n) / glm::dot(ray, n);
  if (!(distance > 0.0)) return false;
  const dvec3 at = distance * ray - centre;
  return std::abs(glm::dot(at, u)) <= glm::dot(u, u) && std::abs(glm::dot(at, v)) <= glm::dot(v, v);
}

} // namespace gg::neighbours_test
