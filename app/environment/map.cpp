#include "environment/map.h"

#include "core/error.h"
#include "image/image.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gg::environment {
namespace {

bool is_radiance(float v) {
  return std::isfinite(v) && v >= 0.0f;
}

} // namespace

std::size_t mend(std::vector<float>& rgb, int width, int height) {
  const std::vector<float> given =
      std::ranges::all_of(rgb, is_radiance) ? std::vector<float>() : rgb;
  if (given.empty()) return 0;
  const auto index = [&](int x, int y, int c) {
    return static_cast<std::size_t>(
        (static_cast<std::ptrdiff_t>(y) * width + (x + width) % width) * 3 + c);
  };
  std::size_t mended = 0;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      bool whole = true;
      for (int c = 0; c < 3; ++c) {
        const float v = given[index(x, y, c)];
        if (is_radiance(v)) continue;
        whole = false;
        double sum = 0.0;
        int count = 0;
        if (!std::isfinite(v))
          for (int k = 0; k < 9; ++k) {
            const int nx = x + k % 3 - 1, ny = y + k / 3 - 1;
            if (ny < 0 || ny >= height) continue;
            const float neighbour = given[index(nx, ny, c)];
            if (!is_radiance(neighbour)) continue;
            sum += static_cast<double>(neighbour);
            ++count;
          }
        rgb[index(x, y, c)] = count ? static_cast<float>(sum / count) : 0.0f;
      }
      if (!whole) ++mended;
    }
  return mended;
}

Map load(const std::filesystem::path& path) {
  const image::Image picture = image::read(path);
  const bool single = picture.width == 1 && picture.height == 1;
  if (picture.width != 2 * picture.height && !single)
    throw Error(ExitCode::input, path.string(),
                "is " + std::to_string(picture.width) + " x " + std::to_string(picture.height)
                    + " pixels; an equirectangular environment is twice as wide as high",
                "Convert the panorama to that projection, or crop it to 2:1.");
  Map map{path.filename().string(), picture.width, picture.height, {}};
  const std::size_t pixels =
      static_cast<std::size_t>(map.width) * static_cast<std::size_t>(map.height);
  map.rgb.reserve(3 * pixels);
  const auto channels = static_cast<std::size_t>(picture.channels);
  for (std::size_t i = 0; i < pixels; ++i)
    for (std::size_t c = 0; c < 3; ++c)
      map.rgb.push_back(picture.values[i * channels + std::min(c, channels - 1)]);
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

Map fitted_between(const Map& map, int least_height, int greatest_width) {
  const int repeat = std::max(1, (least_height + map.height - 1) / map.height);
  int shrink = std::max(1, (map.width + greatest_width - 1) / greatest_width);
  while (map.width % shrink || map.height % shrink)
    ++shrink; // at the latest at the height, which divides both
  if (repeat == 1 && shrink == 1) return map;
  // A single pixel is as wide as it is high: it becomes two to one.
  const int stretch = map.width == map.height ? 2 : 1;
  Map fitted{map.name, stretch * repeat * map.width / shrink, repeat * map.height / shrink, {}};
  fitted.rgb.reserve(3 * static_cast<std::size_t>(fitted.width)
                     * static_cast<std::size_t>(fitted.height));
  for (int y = 0; y < fitted.height; ++y)
    for (int x = 0; x < fitted.width; ++x) {
      glm::dvec3 sum(0.0);
      double total = 0.0;
      for (int j = 0; j < shrink; ++j) {
        const int row = y * shrink / repeat + j;
        const double weight = pixel_solid_angle(map.width, map.height, row);
        for (int i = 0; i < shrink; ++i)
          sum += weight * glm::dvec3(map.at(x * shrink / (repeat * stretch) + i, row));
        total += weight * shrink;
      }
      for (int c = 0; c < 3; ++c)
        fitted.rgb.push_back(static_cast<float>(sum[c] / total));
    }
  return fitted;
}

} // namespace gg::environment
