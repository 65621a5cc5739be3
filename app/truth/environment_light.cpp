#include "truth/environment_light.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gg::truth {
namespace {

using std::numbers::pi;

// Of a distribution cumulated from 0 to 1 in n + 1 steps, the cell that u falls into, searched from
// `first` on. Cells of no width are never drawn.
template <class T>
int cell_at(const T* cumulated, int n, double u, int first) {
  int cell = first;
  while (cell < n - 1 && static_cast<double>(cumulated[cell + 1]) <= u)
    ++cell;
  return cell;
}

// Where the search begins for u in [k / n, (k + 1) / n).
template <class T>
void index_of(const T* cumulated, int n, std::int32_t* first) {
  int cell = 0;
  for (int k = 0; k < n; ++k) {
    cell = cell_at(cumulated, n, static_cast<double>(k) / n, cell);
    first[k] = cell;
  }
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
  for (int j = 0; j <= height_; ++j)
    edges_.push_back(std::cos(pi * static_cast<double>(j) / height_));
  const auto solid_angle = [&](int y) { // of a cell, up to a factor
    return edges_[static_cast<std::size_t>(y)] - edges_[static_cast<std::size_t>(y) + 1];
  };
  double whole = 0.0;
  for (int y = 0; y < height_; ++y)
    for (int x = 0; x < width_; ++x)
      whole += power(x, y) * solid_angle(y);
  const double mean = whole / (2.0 * width_);
  mean_ = intensity_ * mean / 3.0;
  // Only what is brighter than the mean is drawn, by how much it is [KarlikSSKM19]. Of a constant environment, whose
  // values the mean equals up to the rounding of its sum (2^-53 for each of 2^21 cells), that is nothing.
  constexpr double rounding = 0x1p-32;
  const double dim = mean * (1.0 + rounding);
  std::vector<double> sums(static_cast<std::size_t>(width_) + 1);
  for (int y = 0; y < height_; ++y) {
    for (int x = 0; x < width_; ++x)
      sums[static_cast<std::size_t>(x) + 1] =
          sums[static_cast<std::size_t>(x)] + std::max(power(x, y) - dim, 0.0);
    const double total = sums.back();
    float* const row = cells_.data() + static_cast<std::size_t>(y) * sums.size();
    for (std::size_t x = 0; x < sums.size(); ++x)
      row[x] = total > 0.0 ? static_cast<float>(sums[x] / total) : 0.0f;
    rows_[static_cast<std::size_t>(y) + 1] =
        rows_[static_cast<std::size_t>(y)] + total * solid_angle(y);
  }
  if (const double total = rows_.back(); total > 0.0) {
    for (double& sum : rows_)
      sum /= total;
  }
  index_cells();
}

void EnvironmentLight::index_cells() {
  first_row_.resize(static_cast<std::size_t>(height_));
  index_of(rows_.data(), height_, first_row_.data());
  first_cell_.resize(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_));
  for (std::size_t y = 0; y < static_cast<std::size_t>(height_); ++y)
    index_of(cells_.data() + y * (static_cast<std::size_t>(width_) + 1), width_,
             first_cell_.data() + y * static_cast<std::size_t>(width_));
}

glm::dvec3 EnvironmentLight::texel(int x, int y) const {
  const int column = ((x % width_) + width_) % width_;
  const int row = std::clamp(y, 0, height_ - 1);
  return glm::dvec3(map_.at(column, row));
}

EnvironmentLight::Place EnvironmentLight::place_of(const glm::dvec3& world) const {
  // The map's own direction: the world's, turned back about +Y.
  const double x = cosine_ * world.x - sine_ * world.z, z = sine_ * world.x + cosine_ * world.z;
  return {(std::atan2(z, x) / (2.0 * pi) + 0.5) * width_,
          std::acos(std::clamp(world.y, -1.0, 1.0)) / pi * height_};
}

glm::dvec3 EnvironmentLight::radiance(const Place& place) const {
  const double x = place.x - 0.5, y = place.y - 0.5;
  const double left = std::floor(x), top = std::floor(y);
  const double fx = x - left, fy = y - top;
  const int i = static_cast<int>(left), j = static_cast<int>(top);
  const auto column = [&](int k) { return k < 0 ? k + width_ : k >= width_ ? k - width_ : k; };
  const auto row = [&](int k) { return std::clamp(k, 0, height_ - 1); };
  const auto at = [&](int across, int down) { return glm::dvec3(map_.at(across, down)); };
  const int i0 = column(i), i1 = column(i + 1), j0 = row(j), j1 = row(j + 1);
  return intensity_
         * ((at(i0, j0) * (1.0 - fx) + at(i1, j0) * fx) * (1.0 - fy)
            + (at(i0, j1) * (1.0 - fx) + at(i1, j1) * fx) * fy);
}

std::optional<EnvironmentLight::Drawn> EnvironmentLight::sample(Random& random, int stratum,
                                                                int strata) const {
  if (!(rows_.back() > 0.0 && intensity_ > 0.0)) return std::nullopt;
  // A rounding below 1 the sum is not reached by (strata - 1 + u) / strata.
  const double across = std::min((stratum + random.uniform()) / strata, 1.0 - 0x1p-53);
  const int row = cell_at(rows_.data(), height_, across,
                          first_row_[static_cast<std::size_t>(across * height_)]);
  const float* const cells =
      cells_.data() + static_cast<std::size_t>(row) * (static_cast<std::size_t>(width_) + 1);
  const double along = random.uniform();
  const int column =
      cell_at(cells, width_, along,
              first_cell_[static_cast<std::size_t>(row) * static_cast<std::size_t>(width_)
                          + static_cast<std::size_t>(along * width_)]);
  const double y = glm::mix(edges_[static_cast<std::size_t>(row)],
                            edges_[static_cast<std::size_t>(row) + 1], random.uniform());
  Drawn drawn;
  drawn.place = {column + random.uniform(), std::acos(y) / pi * height_};
  const double phi = 2.0 * pi * (drawn.place.x / width_ - 0.5);
  const double r = std::sqrt(std::max((1.0 - y) * (1.0 + y), 0.0));
  const glm::dvec3 d(r * std::cos(phi), y, r * std::sin(phi));
  drawn.direction = {cosine_ * d.x + sine_ * d.z, d.y, -sine_ * d.x + cosine_ * d.z};
  drawn.pdf = pdf(drawn.place);
  if (!(drawn.pdf > 0.0)) return std::nullopt;
  return drawn;
}

double EnvironmentLight::pdf(const Place& place) const {
  const int row = std::clamp(static_cast<int>(place.y), 0, height_ - 1);
  const int column = std::clamp(static_cast<int>(place.x), 0, width_ - 1);
  const std::size_t y = static_cast<std::size_t>(row);
  const float* const cells = cells_.data() + y * (static_cast<std::size_t>(width_) + 1);
  const double chance =
      (rows_[y + 1] - rows_[y]) * static_cast<double>(cells[column + 1] - cells[column]);
  return chance / (2.0 * pi / width_ * (edges_[y] - edges_[y + 1]));
}

} // namespace gg::truth
