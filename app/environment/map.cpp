#include "environment/map.h"

#include "core/error.h"
#include "image/image.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>

namespace gg::environment {
namespace {

bool is_radiance(float v) {
  return std::isfinite(v) && v >= 0.0f;
}

} // namespace

std::size_t mend(std::vector<float>& rgb, int width, int height) {
  if (std::ranges::all_of(rgb, is_radiance)) return 0;
  const auto index = [&](int x, int y, int c) {
    return static_cast<std::size_t>(
        (static_cast<std::ptrdiff_t>(y) * width + (x + width) % width) * 3 + c);
  };
  // Rows as they were given: the one above and this one, which are changed, and the one below, which is not yet.
  std::vector<float> above, here;
  std::size_t mended = 0;
  for (int y = 0; y < height; ++y) {
    above.swap(here);
    here.assign(rgb.begin() + static_cast<std::ptrdiff_t>(index(0, y, 0)),
                rgb.begin() + static_cast<std::ptrdiff_t>(index(0, y, 0)) + 3 * width);
    const auto given = [&](int x, int ny, int c) {
      return ny > y ? rgb[index(x, ny, c)] : (ny < y ? above : here)[index(x, 0, c)];
    };
    for (int x = 0; x < width; ++x) {
      bool whole = true;
      for (int c = 0; c < 3; ++c) {
        const float v = given(x, y, c);
        if (is_radiance(v)) continue;
        whole = false;
        double sum = 0.0;
        int count = 0;
        if (!std::isfinite(v))
          for (int k = 0; k < 9; ++k) {
            const int nx = x + k % 3 - 1, ny = y + k / 3 - 1;
            if (ny < 0 || ny >= height) continue;
            const float neighbour = given(nx, ny, c);
            if (!is_radiance(neighbour)) continue;
            sum += static_cast<double>(neighbour);
            ++count;
          }
        rgb[index(x, y, c)] = count ? static_cast<float>(sum / count) : 0.0f;
      }
      if (!whole) ++mended;
    }
  }
  return mended;
}

bool is_map_file(const std::filesystem::path& path) {
  return path.extension() == ".hdr" || path.extension() == ".exr";
}

Map load(const std::filesystem::path& path) {
  image::Image picture = image::read(path);
  const bool single = picture.width == 1 && picture.height == 1;
  // Programs that scale or crop a panorama may miss 2:1 by a pixel or two; what is meant is clear, and a hundredth of the
  // height moves nothing by more than 1.8 degrees.
  const int off = std::abs(picture.width - 2 * picture.height);
  if (off != 0 && off <= picture.height / 100)
    note(path.string() + ": is " + std::to_string(picture.width) + " x "
         + std::to_string(picture.height)
         + " pixels, not quite twice as wide as high; taken as the whole sphere");
  else if (off != 0 && !single)
    throw Error(ExitCode::input, path.string(),
                "is " + std::to_string(picture.width) + " x " + std::to_string(picture.height)
                    + " pixels; an equirectangular environment is twice as wide as high",
                "Convert the panorama to that projection, or crop it to 2:1.");
  Map map{path.filename().string(), picture.width, picture.height, {}};
  const std::size_t pixels =
      static_cast<std::size_t>(map.width) * static_cast<std::size_t>(map.height);
  // In place: alpha is left out, and a large panorama is in memory once.
  map.rgb = std::move(picture.values);
  const auto channels = static_cast<std::size_t>(picture.channels); // 3 or 4
  for (std::size_t i = 1; i < pixels && channels != 3; ++i)
    for (std::size_t c = 0; c < 3; ++c)
      map.rgb[3 * i + c] = map.rgb[channels * i + c];
  map.rgb.resize(3 * pixels);
  if (const std::size_t mended = mend(map.rgb, map.width, map.height))
    note(path.string() + ": " + std::to_string(mended) + " of " + std::to_string(pixels)
         + " pixels were not finite or were negative and have been mended (the mean of their "
           "neighbours, or 0)");
  return map;
}

Map constant(const glm::vec3& radiance) {
  Map map{"constant", 1, 1, {}};
  for (int c = 0; c < 3; ++c)
    map.rgb.push_back(is_radiance(radiance[c]) ? radiance[c] : 0.0f);
  return map;
}

double pixel_solid_angle(int width, int height, int y) {
  // 2π/width (cos θ0 - cos θ1), the difference as a product: at the poles it is a small one of numbers near 1.
  const double step = std::numbers::pi / height;
  return 2.0 * std::numbers::pi / width * 2.0 * std::sin((y + 0.5) * step) * std::sin(0.5 * step);
}

glm::dvec3 mean_radiance(const Map& map) {
  glm::dvec3 sum(0.0);
  for (int y = 0; y < map.height; ++y) {
    glm::dvec3 row(0.0);
    for (int x = 0; x < map.width; ++x)
      row += glm::dvec3(map.at(x, y));
    sum += row * pixel_solid_angle(map.width, map.height, y);
  }
  return sum / (4.0 * std::numbers::pi);
}

namespace {

// How much each of the `from` cells of a line counts in cell `i` of `to` equal ones: the overlap, as (first cell, weights).
// `edge` gives the measure up to a place of the line, in 0..1.
struct Overlap {
  int first = 0;
  std::vector<double> weights; // they add up to 1
};

template <class Edge>
std::vector<Overlap> overlaps(int from, int to, const Edge& edge) {
  std::vector<Overlap> result(static_cast<std::size_t>(to));
  for (int i = 0; i < to; ++i) {
    Overlap& overlap = result[static_cast<std::size_t>(i)];
    // In whole numbers, places being multiples of 1 / (from * to): cells that meet exactly do not overlap by a rounding.
    const long long low = static_cast<long long>(i) * from, high = low + from;
    overlap.first = static_cast<int>(low / to);
    double total = 0.0;
    for (long long at = overlap.first; at * to < high; ++at) {
      const double one = static_cast<double>(from) * to;
      const double a = static_cast<double>(std::max(low, at * to)) / one;
      const double b = static_cast<double>(std::min(high, (at + 1) * to)) / one;
      overlap.weights.push_back(edge(a, b));
      total += overlap.weights.back();
    }
    for (double& weight : overlap.weights)
      weight /= total;
  }
  return result;
}

Map resized(const Map& map, int width, int height) {
  const std::vector<Overlap> across =
      overlaps(map.width, width, [](double a, double b) { return b - a; });
  // cos pi a - cos pi b, as a product: at the poles it is a small difference of numbers near 1.
  const std::vector<Overlap> down = overlaps(map.height, height, [](double a, double b) {
    return std::sin(0.5 * std::numbers::pi * (a + b)) * std::sin(0.5 * std::numbers::pi * (b - a));
  });
  Map result{map.name, width, height, {}};
  result.rgb.reserve(3 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  for (const Overlap& rows : down)
    for (const Overlap& columns : across) {
      glm::dvec3 sum(0.0);
      for (std::size_t j = 0; j < rows.weights.size(); ++j)
        for (std::size_t i = 0; i < columns.weights.size(); ++i)
          sum += rows.weights[j] * columns.weights[i]
                 * glm::dvec3(
                     map.at(columns.first + static_cast<int>(i), rows.first + static_cast<int>(j)));
      for (int c = 0; c < 3; ++c)
        result.rgb.push_back(static_cast<float>(sum[c]));
    }
  return result;
}

} // namespace

Map fitted_between(const Map& map, int least_height, int greatest_width) {
  if (map.width > greatest_width)
    return resized(map, greatest_width, std::max(1, greatest_width / 2));
  if (map.height >= least_height) return map;
  const int repeat = (least_height + map.height - 1) / map.height;
  return resized(map, 2 * repeat * map.height, repeat * map.height);
}

} // namespace gg::environment
