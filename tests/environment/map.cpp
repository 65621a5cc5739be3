// Environments as pictures: what is mended, what is refused, and which way is up.
#include "core/error.h"
#include "environment/support.h"
#include "image/image.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <limits>
#include <numbers>

namespace gg::environment {
namespace {

constexpr float nan = std::numeric_limits<float>::quiet_NaN(),
                infinity = std::numeric_limits<float>::infinity();

std::filesystem::path written(const std::string& name, const image::Image& picture) {
  const std::filesystem::path directory =
      std::filesystem::path(GROUNDGLASS_OUTPUT_DIR) / "environment";
  std::filesystem::create_directories(directory);
  image::write(directory / name, picture);
  return directory / name;
}

TEST(environment_map, what_is_not_radiance_is_mended_and_counted) {
  std::vector<float> rgb(3 * 8 * 4, 2.0f);
  const auto at = [&](int x, int y, int c) -> float& {
    return rgb[static_cast<std::size_t>((y * 8 + x) * 3 + c)];
  };
  at(0, 0, 0) = nan; // a corner: its neighbours are across the seam too
  at(7, 0, 0) = 8.0f;
  at(3, 2, 1) = infinity;
  at(3, 2, 2) = -1.0f;
  at(5, 3, 0) = -infinity;
  EXPECT_EQ(mend(rgb, 8, 4), 3u);
  EXPECT_FLOAT_EQ(at(0, 0, 0), (4 * 2.0f + 8.0f) / 5);
  EXPECT_FLOAT_EQ(at(3, 2, 1), 2.0f);
  EXPECT_EQ(at(3, 2, 2), 0.0f);
  EXPECT_FLOAT_EQ(at(5, 3, 0), 2.0f);
  for (float v : rgb)
    EXPECT_TRUE(std::isfinite(v) && v >= 0.0f);
}

TEST(environment_map, a_picture_of_nothing_but_nan_is_black) {
  std::vector<float> rgb(3 * 4 * 2, nan);
  EXPECT_EQ(mend(rgb, 4, 2), 8u);
  for (float v : rgb)
    EXPECT_EQ(v, 0.0f);
}

TEST(environment_map, load_mends_and_says_so) {
  image::Image picture(4, 2, 3);
  picture.at(1, 1, 0) = nan;
  picture.at(2, 0, 2) = -5.0f;
  testing::internal::CaptureStderr();
  const Map map = load(written("damaged.exr", picture));
  const std::string said = testing::internal::GetCapturedStderr();
  EXPECT_NE(said.find("damaged.exr"), std::string::npos) << said;
  EXPECT_NE(said.find("2 of 8 pixels"), std::string::npos) << said;
  for (float v : map.rgb)
    EXPECT_EQ(v, 0.0f);
}

TEST(environment_map, only_panoramas_twice_as_wide_as_high_are_taken) {
  const std::filesystem::path path = written("square.exr", image::Image(6, 6, 3));
  try {
    load(path);
    FAIL() << "took a square picture";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ExitCode::input);
    EXPECT_NE(std::string(error.what()).find("6 x 6"), std::string::npos) << error.what();
  }
}

TEST(environment_map, a_panorama_that_misses_two_to_one_by_a_hundredth_is_taken) {
  EXPECT_EQ(load(written("nearly.exr", image::Image(401, 200, 3))).width, 401);
  EXPECT_THROW(load(written("not_nearly.exr", image::Image(404, 200, 3))), Error);
}

// A height without small factors, and one that just misses the limit: neither loses more than it must.
TEST(environment_map, any_size_is_fitted_without_losing_resolution) {
  const auto sky = [](const glm::dvec3& d) { return glm::dvec3(1.0 + d.y, d.x * d.x, 2.0 + d.z); };
  for (const int height : {257, 205, 103, 2 * 101}) {
    const Map map = picture_of(2 * height, sky);
    const Map fitted = fitted_between(map, 16, 200);
    ASSERT_EQ(fitted.width, 200);
    ASSERT_EQ(fitted.height, 100);
    const Map wanted = picture_of(200, sky);
    double worst = 0.0;
    for (std::size_t i = 0; i < wanted.rgb.size(); ++i)
      worst = std::max(worst, std::abs(static_cast<double>(fitted.rgb[i] - wanted.rgb[i])));
    // The map is taken as constant over each of its pixels: its gradient, at most 1 per radian, times half of one.
    EXPECT_LT(worst, std::numbers::pi / (2 * height)) << height;
    const glm::dvec3 a = mean_radiance(map), b = mean_radiance(fitted);
    for (int c = 0; c < 3; ++c)
      EXPECT_NEAR(a[c], b[c], 1e-6) << height;
  }
}

TEST(environment_map, fitting_keeps_the_mean) {
  const Map map =
      picture_of(64, [](const glm::dvec3& d) { return glm::dvec3(1.0 + d.y, d.x * d.x, 3.0); });
  for (const Map& fitted :
       {fitted_between(map, 128, 4096), fitted_between(map, 4, 16), fitted_between(map, 4, 2)}) {
    const glm::dvec3 a = mean_radiance(map), b = mean_radiance(fitted);
    // float32 storage of the pixels
    for (int c = 0; c < 3; ++c)
      EXPECT_NEAR(a[c], b[c], 1e-6) << fitted.width;
  }
  const Map one = fitted_between(constant({1, 2, 3}), 32, 4096);
  EXPECT_EQ(one.width, 64);
  EXPECT_EQ(one.at(63, 31), glm::vec3(1, 2, 3));
}

} // namespace
} // namespace gg::environment
