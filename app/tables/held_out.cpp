#include "tables/held_out.h"

#include "core/files.h"
#include "image/image.h"
#include "tables/training_maps.h"

#include <tbb/parallel_for.h>

#include <cmath>
#include <numbers>

namespace gg::tables {
namespace {

constexpr double floor_share = 0.2; // of the map's geometric mean, as in the fits

constexpr const char* pictures[] = {"moonless_golf_1k.hdr", "qwantani_afternoon_puresky_1k.hdr",
                                    "royal_esplanade_1k.hdr", "studio_small_03_1k.hdr"};

// Luminance, bilinear. Directions as in app/environment/map.h.
SphereMap picture(const std::string& file, int size) {
  const image::Image map = image::read(home_directory() / "assets" / "environments" / file);
  return sample_sphere(size, [&](const glm::vec3& d) {
    const double u = (std::atan2(d.z, d.x) / (2.0 * std::numbers::pi) + 0.5) * map.width - 0.5;
    const double v = std::acos(std::clamp(d.y, -1.0f, 1.0f)) / std::numbers::pi * map.height - 0.5;
    const int x = static_cast<int>(std::floor(u)), y = static_cast<int>(std::floor(v));
    double sum = 0.0;
    for (int k = 0; k < 4; ++k) {
      const int i = x + k % 2, j = y + k / 2;
      const double w = (1.0 - std::abs(u - i)) * (1.0 - std::abs(v - j));
      const int column = (i + map.width) % map.width, row = std::clamp(j, 0, map.height - 1);
      sum += w
             * (0.2126 * static_cast<double>(map.at(column, row, 0))
                + 0.7152 * static_cast<double>(map.at(column, row, 1))
                + 0.0722 * static_cast<double>(map.at(column, row, 2)));
    }
    return static_cast<float>(sum);
  });
}

// The map is the first blurred level of its stack, for lobes and for lookups alike: in the sharp one a sun is a single texel,
// which even thousands of samples hit or miss (up to .6 in ln).
double seen_through(const SphereStack& stack, double sigma) {
  return std::hypot(sigma, stack.sigma(1));
}

} // namespace

Training held_out_maps(int map_size, int rotations) {
  std::vector<SphereMap> maps;
  for (const char* file : pictures)
    maps.push_back(picture(file, map_size));
  for (int draw : held_out_draws)
    for (const TrainingMap& map : training_maps(map_size, draw))
      maps.push_back(map.map);
  return Training(stacks_of(maps), rotations, 2);
}

std::vector<double> radiance(const Training& training, const std::vector<LobeSample>& lobe,
                             const std::vector<double>& weights, double spread) {
  const auto weight = [&](std::size_t s) { return weights.empty() ? lobe[s].weight : weights[s]; };
  double total = 0.0;
  for (std::size_t s = 0; s < lobe.size(); ++s)
    total += weight(s);
  std::vector<int> levels;
  const SphereStack& any = training.stack(training.views().front());
  for (const LobeSample& s : lobe)
    levels.push_back(any.nearest_level(seen_through(any, spread / std::sqrt(s.density))));
  std::vector<double> result(training.views().size());
  tbb::parallel_for(std::size_t{0}, result.size(), [&](std::size_t v) {
    const Training::View& view = training.views()[v];
    const SphereStack& stack = training.stack(view);
    for (std::size_t s = 0; s < lobe.size(); ++s)
      result[v] += weight(s) / total
                   * static_cast<double>(stack.level(levels[s]).radiance(view.world_from_local
                                                                         * glm::vec3(lobe[s].wi)));
  });
  return result;
}

std::vector<double> squared_log_errors(const Training& training, const std::vector<double>& truth,
                                       const std::vector<double>& light) {
  std::vector<double> squares;
  for (std::size_t v = 0; v < truth.size(); ++v) {
    const double floor = floor_share * training.stack(training.views()[v]).geometric_mean;
    squares.push_back(std::pow(std::log((light[v] + floor) / (truth[v] + floor)), 2.0));
  }
  return squares;
}

std::vector<double> squared_log_errors(const Training& training, const std::vector<double>& truth,
                                       const std::vector<Lookup>& lookups) {
  std::vector<double> light(truth.size());
  tbb::parallel_for(std::size_t{0}, truth.size(), [&](std::size_t v) {
    const Training::View& view = training.views()[v];
    for (const Lookup& l : lookups)
      light[v] += l.weight
                  * static_cast<double>(
                      training.stack(view).radiance(view.world_from_local * glm::vec3(l.direction),
                                                    seen_through(training.stack(view), l.sigma)));
  });
  return squared_log_errors(training, truth, light);
}

double log_error(const Training& training, const std::vector<double>& truth,
                 const std::vector<Lookup>& lookups) {
  double sum = 0.0;
  for (double s : squared_log_errors(training, truth, lookups))
    sum += s;
  return std::sqrt(sum / static_cast<double>(truth.size()));
}

int picture_views(const Training& training) {
  int count = 0;
  for (const Training::View& view : training.views())
    count += view.stack < static_cast<int>(std::size(pictures));
  return count;
}

} // namespace gg::tables
