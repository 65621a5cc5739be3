#include "truth/environment_light.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gg::truth {
namespace {

using std::numbers::pi;

// Of a distribution cumulated from 0 to 1 in n + 1 steps, the cell that u falls into. Cells of no
// width are never drawn.
template <class T>
int cell_at(const T* cumulated, int n, double u) {
  const T* const found = std::upper_bound(cumulated + 1, cumulated + n, static_cast<double>(u),
                                          [](double value, T step) { return value < step; });
  return static_cast<int>(found - cumulated) - 1;
}

// Cosine of the polar angle at the upper edge of row j of n.
double edge(int j, int n) {
  return std::cos(pi * static_cast<double>(j) / n);
}

} // namespace

EnvironmentLight::EnvironmentLight(environment::Map map, double rotation, double intensity)
    : map_(std::move(map)), width_(map_.width), height_(map_.height), cosine_(std::cos(rotation)),
      sine_(std::sin(rotation)), intensity_(intensity) {
  // The mean of the bilinear surface over a texel's own rectangle weighs it by 3/4 and its
  // neighbours by 1/8 along each axis.
  const auto smoothed_row = [&](int y, int x) {
    return 0.125 * texel(x - 1, y) + 0.75 * texel(x, y) + 0.125 * texel(x + 1, y);
  };
  const auto power = [&](int x, int y) {
    const glm::dvec3 mean =
        0.125 * smoothed_row(y - 1, x) + 0.75 * smoothed_row(y, x) + 0.125 * smoothed_row(y + 1, x);
    return mean.x + mean.y + mean.z;
  };
  rows_.assign(static_cast<std::size_t>(height_) + 1, 0.0);
  cells_.assign((static_cast<std::size_t>(width_) + 1) * static_cast<std::size_t>(height_), 0.0f);
  std::vector<double> sums(static_cast<std::size_t>(width_) + 1);
  for (int y = 0; y < height_; ++y) {
    for (int x = 0; x < width_; ++x)
      sums[static_cast<std::size_t>(x) + 1] = sums[static_cast<std::size_t>(x)] + power(x, y);
    const double total = sums.back();
    float* const row = cells_.data() + static_cast<std::size_t>(y) * sums.size();
    for (std::size_t x = 0; x < sums.size(); ++x)
      row[x] = total > 0.0 ? static_cast<float>(sums[x] / total) : 0.0f;
    const double solid_angle = edge(y, height_) - edge(y + 1, height_); // of a cell, up to a factor
    rows_[static_cast<std::size_t>(y) + 1] =
        rows_[static_cast<std::size_t>(y)] + total * solid_angle;
  }
  if (const double total = rows_.back(); total > 0.0)
    for (double& sum : rows_)
      sum /= total;
}

glm::dvec3 EnvironmentLight::texel(int x, int y) const {
  const int column = ((x % width_) + width_) % width_;
  const int row = std::clamp(y, 0, height_ - 1);
  return glm::dvec3(map_.at(column, row));
}

glm::dvec3 EnvironmentLight::in_map(const glm::dvec3& d) const {
  // The map's own direction: the world's, turned back about +Y.
  return {cosine_ * d.x - sine_ * d.z, d.y, sine_ * d.x + cosine_ * d.z};
}

glm::dvec3 EnvironmentLight::radiance(const glm::dvec3& direction) const {
  const glm::dvec3 d = in_map(direction);
  const double u = std::atan2(d.z, d.x) / (2.0 * pi) + 0.5;
  const double v = std::acos(std::clamp(d.y, -1.0, 1.0)) / pi;
  const double x = u * width_ - 0.5, y = v * height_ - 0.5;
  const double left = std::floor(x), top = std::floor(y);
  const double fx = x - left, fy = y - top;
  const int i = static_cast<int>(left), j = static_cast<int>(top);
  return intensity_
         * ((texel(i, j) * (1.0 - fx) + texel(i + 1, j) * fx) * (1.0 - fy)
            + (texel(i, j + 1) * (1.0 - fx) + texel(i + 1, j + 1) * fx) * fy);
}

int EnvironmentLight::row_of(double y) const {
  const double v = std::acos(std::clamp(y, -1.0, 1.0)) / pi;
  return std::clamp(static_cast<int>(v * height_), 0, height_ - 1);
}

std::optional<EnvironmentLight::Drawn> EnvironmentLight::sample(Random& random) const {
  if (!(rows_.back() > 0.0 && intensity_ > 0.0)) return std::nullopt;
  const int row = cell_at(rows_.data(), height_, random.uniform());
  const float* const cells =
      cells_.data() + static_cast<std::size_t>(row) * (static_cast<std::size_t>(width_) + 1);
  const int column = cell_at(cells, width_, random.uniform());
  const double y = glm::mix(edge(row, height_), edge(row + 1, height_), random.uniform());
  const double phi = 2.0 * pi * ((column + random.uniform()) / width_ - 0.5);
  const double r = std::sqrt(std::max((1.0 - y) * (1.0 + y), 0.0));
  const glm::dvec3 d(r * std::cos(phi), y, r * std::sin(phi));
  Drawn drawn;
  drawn.direction = {cosine_ * d.x + sine_ * d.z, d.y, -sine_ * d.x + cosine_ * d.z};
  drawn.radiance = radiance(drawn.direction);
  drawn.pdf = pdf(drawn.direction);
  if (!(drawn.pdf > 0.0)) return std::nullopt;
  return drawn;
}

double EnvironmentLight::pdf(const glm::dvec3& direction) const {
  const glm::dvec3 d = in_map(direction);
  const int row = row_of(d.y);
  const double u = std::atan2(d.z, d.x) / (2.0 * pi) + 0.5;
  const int column = std::clamp(static_cast<int>(u * width_), 0, width_ - 1);
  const float* const cells =
      cells_.data() + static_cast<std::size_t>(row) * (static_cast<std::size_t>(width_) + 1);
  const double chance =
      (rows_[static_cast<std::size_t>(row) + 1] - rows_[static_cast<std::size_t>(row)])
      * static_cast<double>(cells[column + 1] - cells[column]);
  const double solid_angle = 2.0 * pi / width_ * (edge(row, height_) - edge(row + 1, height_));
  return chance / solid_angle;
}

} // namespace gg::truth
