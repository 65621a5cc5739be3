#include "truth/environment_light.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gg::truth {
namespace {

using std::numbers::pi;

// Of a distribution cumulated to 1 in n steps, of which end(i) is the sum up to and with step i: the step that u falls
// into, searched from `first` on. Steps of no width are never drawn.
template <class End>
int step_at(const End& end, int n, double u, int first) {
  int step = first;
  while (step < n - 1 && end(step) <= u)
    ++step;
  return step;
}

// Where the search begins for u in [k / searches, (k + 1) / searches).
template <class End>
void index_steps(const End& end, int n, int searches, std::vector<std::int32_t>& first) {
  int step = 0;
  for (int k = 0; k < searches; ++k) {
    step = step_at(end, n, static_cast<double>(k) / searches, step);
    first.push_back(step);
  }
}

// Of a row of cells, RGB. The mean of the bilinear surface over a texel's own rectangle weighs it by 3/4 and its neighbours
// by 1/8 along each axis.
void read_powers(const environment::Map& map, int y, std::vector<double>& powers) {
  const auto down = [&](int x) {
    const auto sum = [&](int row) {
      const glm::dvec3 v(map.at(x, std::clamp(row, 0, map.height - 1)));
      return v.x + v.y + v.z;
    };
    return 0.125 * sum(y - 1) + 0.75 * sum(y) + 0.125 * sum(y + 1);
  };
  double left = down(map.width - 1), here = down(0);
  const double first = here;
  for (int x = 0; x < map.width; ++x) {
    const double right = x + 1 < map.width ? down(x + 1) : first;
    powers[static_cast<std::size_t>(x)] = 0.125 * left + 0.75 * here + 0.125 * right;
    left = here, here = right;
  }
}

} // namespace

EnvironmentLight::EnvironmentLight(environment::Map map, double rotation, double intensity)
    : width_(map.width), height_(map.height), cosine_(std::cos(rotation)),
      sine_(std::sin(rotation)), intensity_(intensity) {
  for (int j = 0; j <= height_; ++j)
    edges_.push_back(std::cos(pi * static_cast<double>(j) / height_));
  const auto solid_angle = [&](int y) { // of a cell, over that of a unit of width
    return edges_[static_cast<std::size_t>(y)] - edges_[static_cast<std::size_t>(y) + 1];
  };
  std::vector<double> powers(static_cast<std::size_t>(width_));
  double whole = 0.0;
  for (int y = 0; y < height_; ++y) {
    read_powers(map, y, powers);
    for (const double power : powers)
      whole += power * solid_angle(y);
  }
  const double mean = whole / (2.0 * width_);
  mean_ = intensity_ * mean / 3.0;
  // Only what is brighter than the mean is drawn, by how much it is [KarlikSSKM19]. Of a constant environment, whose
  // values the mean equals up to the rounding of its sum (2^-53 for each of 2^21 cells), that is nothing.
  constexpr double rounding = 0x1p-32;
  const double dim = mean * (1.0 + rounding);
  rows_.push_back(0.0);
  texels_.reserve(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_));
  for (int y = 0; y < height_; ++y) {
    read_powers(map, y, powers);
    for (double& power : powers)
      power = std::max(power - dim, 0.0);
    rows_.push_back(rows_.back() + add_row(powers) * solid_angle(y));
    for (int x = 0; x < width_; ++x)
      texels_.emplace_back(map.at(x, y), 0.0f);
  }
  if (const double total = rows_.back(); total > 0.0)
    for (double& sum : rows_)
      sum /= total;
  index_steps([&](int y) { return rows_[static_cast<std::size_t>(y) + 1]; }, height_, height_,
              first_row_);
  for (int y = 0; y < height_; ++y)
    note_densities(y, 2.0 * pi / width_ * solid_angle(y));
}

// The cells of a row that have power; its sum.
double EnvironmentLight::add_row(const std::vector<double>& powers) {
  double total = 0.0;
  for (const double power : powers)
    total += power;
  Row row{.cells = cells_.size(), .firsts = first_cell_.size()};
  double sum = 0.0;
  float end = 0.0f;
  for (std::size_t x = 0; x < powers.size() && total > 0.0; ++x) {
    sum += powers[x];
    const float next = static_cast<float>(sum / total);
    if (!(next > end)) continue;
    end = next;
    cells_.push_back({.end = end, .column = static_cast<std::int32_t>(x)});
  }
  row.count = static_cast<int>(cells_.size() - row.cells);
  const Cell* const cells = cells_.data() + row.cells;
  index_steps([&](int i) { return static_cast<double>(cells[i].end); }, row.count, row.searches(),
              first_cell_);
  cells_of_.push_back(row);
  return total;
}

void EnvironmentLight::note_densities(int y, double solid_angle) {
  const std::size_t row = static_cast<std::size_t>(y);
  const double chance = rows_[row + 1] - rows_[row];
  double begin = 0.0;
  for (int i = 0; i < cells_of_[row].count; ++i) {
    const Cell& cell = cells_[cells_of_[row].cells + static_cast<std::size_t>(i)];
    const double end = static_cast<double>(cell.end);
    texels_[start_of(y) + static_cast<std::size_t>(cell.column)].w =
        static_cast<float>(chance * (end - begin) / solid_angle);
    begin = end;
  }
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
  const int i0 = column(i), i1 = column(i + 1);
  const glm::vec4 *const above = texels_.data() + start_of(row(j)), *const below =
                                                                        texels_.data()
                                                                        + start_of(row(j + 1));
  const auto along = [&](const glm::vec4* texels) {
    return glm::dvec3(texels[i0]) * (1.0 - fx) + glm::dvec3(texels[i1]) * fx;
  };
  return intensity_ * (along(above) * (1.0 - fy) + along(below) * fy);
}

std::optional<EnvironmentLight::Drawn> EnvironmentLight::sample(Random& random, int stratum,
                                                                int strata) const {
  if (!(rows_.back() > 0.0 && intensity_ > 0.0)) return std::nullopt;
  // A rounding below 1 the sum is not reached by (strata - 1 + u) / strata.
  const double across = std::min((stratum + random.uniform()) / strata, 1.0 - 0x1p-53);
  const int row = step_at([&](int y) { return rows_[static_cast<std::size_t>(y) + 1]; }, height_,
                          across, first_row_[static_cast<std::size_t>(across * height_)]);
  const Row& of = cells_of_[static_cast<std::size_t>(row)];
  if (of.count == 0) return std::nullopt; // a row whose power rounding lost
  const Cell* const cells = cells_.data() + of.cells;
  const double along = random.uniform();
  const std::int32_t first =
      first_cell_[of.firsts + static_cast<std::size_t>(along * of.searches())];
  const int column = cells[step_at([&](int i) { return static_cast<double>(cells[i].end); },
                                   of.count, along, first)]
                         .column;
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
  return static_cast<double>(texels_[start_of(row) + static_cast<std::size_t>(column)].w);
}

} // namespace gg::truth
