// A lobe by its parts is the lobe: what the samples of a pixel rely on.
#include "glsl/f64.h"
#include "uniforms/camera.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <cmath>

namespace gg::composition_test {
namespace {

namespace f64 = gg::glsl::f64;
using glm::dvec3;

constexpr double rounding = 1e-9; // sums of up to 256 parts, roots of differences near 0

const int counts[] = {3, 4, 5, 16, 64, 256};

f64::vec3 asked(const dvec3& part) {
  return {part.x, part.y, part.z};
}

} // namespace

TEST(lobe_stratum, parts_have_the_mean_and_the_variance_of_the_whole) {
  for (const int count : counts) {
    double x = 0.0, y = 0.0, xx = 0.0, xy = 0.0, yy = 0.0, kept = 0.0;
    for (int i = 0; i < count; ++i) {
      const dvec3 part = uniforms::lobe_stratum(i, count);
      x += part.x / count;
      y += part.y / count;
      xx += part.x * part.x / count;
      xy += part.x * part.y / count;
      yy += part.y * part.y / count;
      kept = part.z;
    }
    EXPECT_GT(kept, 0.0) << count;
    EXPECT_NEAR(x, 0.0, rounding) << count;
    EXPECT_NEAR(y, 0.0, rounding) << count;
    EXPECT_NEAR(xx + kept * kept, 1.0, rounding) << count;
    EXPECT_NEAR(yy + kept * kept, 1.0, rounding) << count;
    EXPECT_NEAR(xy, 0.0, rounding) << count;
  }
}

TEST(lobe_stratum, one_sample_or_two_are_the_whole_lobe) {
  for (const int count : {1, 2})
    for (int i = 0; i < count; ++i)
      EXPECT_EQ(uniforms::lobe_stratum(i, count), dvec3(0, 0, 1)) << count;
  const dvec3 direction = normalize(dvec3(0.3, -0.5, 0.8));
  const auto whole = f64::lobeStratum(direction, 0.2, 0.1, 0.05, asked({0, 0, 1}));
  EXPECT_NEAR(length(dvec3(whole.direction) - direction), 0.0, rounding);
  EXPECT_EQ(dvec3(whole.aside), dvec3(0.0));
  EXPECT_NEAR(whole.sigma, 0.2, rounding);
  EXPECT_NEAR(whole.inner, 0.1, rounding);
  EXPECT_NEAR(whole.carried, 0.05, rounding);
}

// Where light comes from at a distance: along each axis across the lobe, the places of the parts' centres and the spread of each
// about its own (lobeVariance) make up the whole lobe's spread, whatever came with it from the first face.
TEST(lobe_stratum, at_any_distance_the_spot_is_as_wide_as_that_of_the_whole) {
  const dvec3 direction = normalize(dvec3(-0.2, 0.4, -0.9));
  const double sigma =
      1e-3; // so that the tangent plane is the sphere to a part in a hundred thousand
  const double flat = 1e-5;
  const dvec3 side = f64::lobeSide(direction), other = cross(direction, side);
  for (const int count : counts)
    for (const double inner : {0.0, 4e-4, 2e-3})
      for (const double together : {-0.9, 0.0, 0.5, 1.0})
        for (const double inside : {0.1, 3.0})
          for (const double outside : {0.0, 0.5, 20.0}) {
            const double carried = inner > 0.0 ? together * sigma : 0.0;
            double along = 0.0, across = 0.0;
            for (int i = 0; i < count; ++i) {
              const auto part = f64::lobeStratum(direction, sigma, inner, carried,
                                                 asked(uniforms::lobe_stratum(i, count)));
              // lobeVariance takes a spread as one that grows: crossed rays are its business elsewhere.
              const double offset = inside * part.inner, angle = outside * part.sigma;
              const double own =
                  angle * angle + 2.0 * offset * outside * part.carried + offset * offset;
              const dvec3 place =
                  inside * dvec3(part.aside)
                  + outside * dvec3(part.direction) / dot(dvec3(part.direction), direction);
              along += (own + std::pow(dot(place, side), 2)) / count;
              across += (own + std::pow(dot(place, other), 2)) / count;
            }
            const double offset = inside * inner, angle = outside * sigma;
            const double whole = angle * angle + 2.0 * offset * outside * carried + offset * offset;
            const double scale = angle * angle + offset * offset;
            EXPECT_NEAR(along, whole, flat * scale + 1e-18)
                << count << ' ' << inner << ' ' << together;
            EXPECT_NEAR(across, whole, flat * scale + 1e-18)
                << count << ' ' << inner << ' ' << together;
          }
}

// Neighbours in the pixel must not be neighbours in the lobe: an edge that cuts the pixel would get a lobe of its own.
TEST(lobe_stratum, the_place_in_the_lobe_does_not_go_with_the_place_in_the_pixel) {
  for (const int count : {16, 64, 256}) {
    double worst = 0.0;
    for (int axis = 0; axis < 2; ++axis) {
      double x = 0.0, y = 0.0, radius = 0.0, position = 0.0, rr = 0.0, pp = 0.0, rp = 0.0;
      for (int i = 0; i < count; ++i) {
        const dvec3 part = uniforms::lobe_stratum(i, count);
        const double at = uniforms::sample_position(i, count)[axis], r = std::hypot(part.x, part.y);
        x += part.x * at / count;
        y += part.y * at / count;
        radius += r / count;
        position += at / count;
        rr += r * r / count;
        pp += at * at / count;
        rp += r * at / count;
      }
      const double spread = std::sqrt((rr - radius * radius) * (pp - position * position));
      worst =
          std::max({worst, std::abs(x), std::abs(y), std::abs(rp - radius * position) / spread});
    }
    // Of numbers by chance: 1 / sqrt(count) each, twice that hardly ever.
    EXPECT_LT(worst, 2.0 / std::sqrt(count)) << count;
  }
}

} // namespace gg::composition_test
