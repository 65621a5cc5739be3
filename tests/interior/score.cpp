#include "interior/score.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace gg::test {

double angle(const glm::dvec3& a, const glm::dvec3& b) {
  return 2.0 * std::asin(std::min(0.5 * glm::length(glm::normalize(a) - glm::normalize(b)), 1.0));
}

double quantile(std::vector<double> values, double q) {
  if (values.empty()) return 0.0;
  const auto at =
      values.begin() + static_cast<std::ptrdiff_t>(q * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

double share_within(double limit, const std::vector<double>& values) {
  if (values.empty()) return 0.0;
  const auto count = std::ranges::count_if(values, [=](double v) { return v <= limit; });
  return 100.0 * static_cast<double>(count) / static_cast<double>(values.size());
}

double mean(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0)
         / static_cast<double>(std::max<std::size_t>(values.size(), 1));
}

void Score::add(const ProbeResult& found, const std::vector<Walk>& truth) {
  for (std::size_t i = 0; i < truth.size(); ++i) {
    const Walk& w = truth[i];
    const Found& f = found.pixels[i];
    // At outlines the rasterizer and the ray caster may disagree about a pixel.
    if (f.bounces == Found::no_glass || w.fate == Fate::none) continue;
    reads.push_back(static_cast<double>(f.reads));
    if (w.fate != Fate::leaves) continue;
    const double error =
        f.bounces >= 0 ? angle(w.direction, glm::dvec3(f.direction)) : 180.0 * degree;
    errors.push_back(error);
    by_reflections[std::min(w.reflections, 3)].push_back(error);
    apart.push_back(glm::distance(w.met.front(), glm::dvec3(f.met)));
  }
  double search = 0.0, layers = 0.0;
  for (const auto& [label, ms] : found.ms)
    (label == "probe" ? search : layers) += ms;
  search_ms = (search_ms * pictures + search) / (pictures + 1);
  layers_ms = (layers_ms * pictures + layers) / (pictures + 1);
  ++pictures;
}

bool is_sound(const ProbeResult& found) {
  return std::ranges::all_of(found.pixels, [](const Found& f) {
    const auto finite = [](auto v) { return std::isfinite(glm::dot(v, v)); };
    if (!finite(f.direction) || !finite(f.met) || !finite(f.curvature)) return false;
    if (!std::isfinite(f.share) || !std::isfinite(f.thickness) || f.share < 0.0f
        || f.share > 1.001f) // rounding of four weights
      return false;
    // A dozen operations on unit vectors, each rounded to 2^-24, and normals of 16 bits.
    return f.bounces == Found::no_glass || std::abs(glm::length(f.direction) - 1.0f) < 1e-4f;
  });
}

} // namespace gg::test
