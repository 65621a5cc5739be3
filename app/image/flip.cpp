#include "image/flip.h"

#include "image/planes.h"

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace gg::image {
namespace {

using glm::dvec3;
using std::numbers::pi;

// Rec. 709 primaries and D65, to XYZ (columns are what R, G and B give).
const glm::dmat3 xyz_from_rgb(0.41239080, 0.21263901, 0.01933082, 0.35758434, 0.71516868,
                              0.11919478, 0.18048079, 0.07219232, 0.95053215);
const glm::dmat3 rgb_from_xyz = glm::inverse(xyz_from_rgb);
const dvec3 white = xyz_from_rgb * dvec3(1.0);

// YCxCz, a linear form of CIELAB in which the filters of contrast sensitivity are defined.
dvec3 ycxcz_from_rgb(const dvec3& rgb) {
  const dvec3 v = xyz_from_rgb * rgb / white;
  return {116.0 * v.y - 16.0, 500.0 * (v.x - v.y), 200.0 * (v.y - v.z)};
}

dvec3 rgb_from_ycxcz(const dvec3& c) {
  const double y = (c.x + 16.0) / 116.0;
  return rgb_from_xyz * (dvec3(y + c.y / 500.0, y, y - c.z / 200.0) * white);
}

dvec3 lab_from_rgb(const dvec3& rgb) {
  const dvec3 v = xyz_from_rgb * rgb / white;
  const auto f = [](double t) {
    constexpr double delta = 6.0 / 29.0;
    return t > delta * delta * delta ? std::cbrt(t) : t / (3.0 * delta * delta) + 4.0 / 29.0;
  };
  return {116.0 * f(v.y) - 16.0, 500.0 * (f(v.x) - f(v.y)), 200.0 * (f(v.y) - f(v.z))};
}

// Colours of dark things look less colourful (the Hunt effect); section 4.1.2.
dvec3 hunt_adjusted(const dvec3& lab) {
  return {lab.x, 0.01 * lab.x * lab.y, 0.01 * lab.x * lab.z};
}

// Distance for large colour differences: lightness by blocks, chroma by the straight line.
double hyab(const dvec3& a, const dvec3& b) {
  return std::abs(a.x - b.x) + std::hypot(a.y - b.y, a.z - b.z);
}

// The three contrast sensitivities as sums of Gaussians a * sqrt(pi / b) * exp(-pi^2 d^2 / b), d in
// degrees; table 1. The second term of the first two is zero there.
struct Sensitivity {
  double a1, b1, a2, b2;
};
constexpr std::array<Sensitivity, 3> sensitivities{
    {{1.0, 0.0047, 0.0, 0.0}, {1.0, 0.0053, 0.0, 0.0}, {34.1, 0.04, 13.5, 0.025}}};
constexpr double widest = 0.04; // the largest b, which sets every filter's radius: 3 sigma of it

int sensitivity_radius() {
  return static_cast<int>(std::ceil(3.0 * std::sqrt(widest / (2.0 * pi * pi)) * pixels_per_degree));
}

// One side of a separable Gaussian, not normalised.
Kernel gaussian(double b) {
  const int radius = sensitivity_radius();
  Kernel kernel;
  for (int x = -radius; x <= radius; ++x)
    kernel.push_back(static_cast<float>(
        std::exp(-pi * pi * x * x / (pixels_per_degree * pixels_per_degree * b))));
  return kernel;
}

double sum(const Kernel& kernel) {
  double total = 0.0;
  for (const float v : kernel)
    total += v;
  return total;
}

Kernel scaled(Kernel kernel, double factor) {
  for (float& v : kernel)
    v = static_cast<float>(v * factor);
  return kernel;
}

// The plane as that channel of the eye sees it.
Plane filtered(const Plane& plane, const Sensitivity& s) {
  const Kernel first = gaussian(s.b1);
  const double weight1 = s.a1 * std::sqrt(pi / s.b1), sum1 = sum(first) * sum(first);
  if (s.a2 == 0.0) {
    const Kernel unit = scaled(first, 1.0 / sum(first));
    return convolve(plane, unit, unit);
  }
  const Kernel second = gaussian(s.b2);
  const double weight2 = s.a2 * std::sqrt(pi / s.b2), sum2 = sum(second) * sum(second);
  const double total = weight1 * sum1 + weight2 * sum2;
  Plane result = convolve(plane, first, scaled(first, weight1 / total));
  const Plane other = convolve(plane, second, scaled(second, weight2 / total));
  for (std::size_t i = 0; i < result.values.size(); ++i)
    result.values[i] += other.values[i];
  return result;
}

using Planes = std::array<Plane, 3>;

Planes ycxcz_planes(const Image& image) {
  Planes planes;
  for (Plane& plane : planes)
    plane = Plane(image.width, image.height);
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) {
      dvec3 rgb;
      for (int c = 0; c < 3; ++c)
        rgb[c] = std::clamp(image.at(x, y, c), 0.0f, 1.0f);
      const dvec3 v = ycxcz_from_rgb(rgb);
      for (int c = 0; c < 3; ++c)
        planes[static_cast<std::size_t>(c)].at(x, y) = static_cast<float>(v[c]);
    }
  return planes;
}

dvec3 perceived(const Planes& planes, std::size_t i) {
  const dvec3 rgb = rgb_from_ycxcz({planes[0].values[i], planes[1].values[i], planes[2].values[i]});
  return hunt_adjusted(lab_from_rgb(glm::clamp(rgb, 0.0, 1.0)));
}

// The colour difference, stretched so that the range 0..1 is used: the lower 40 % of the largest
// possible difference takes 95 % of it; section 4.1.3.
double redistributed(double difference) {
  constexpr double exponent = 0.7, knee = 0.4, knee_value = 0.95;
  static const double largest = std::pow(hyab(hunt_adjusted(lab_from_rgb({0.0, 1.0, 0.0})),
                                              hunt_adjusted(lab_from_rgb({0.0, 0.0, 1.0}))),
                                         exponent);
  const double v = std::pow(difference, exponent);
  if (v < knee * largest) return v * knee_value / (knee * largest);
  return knee_value + (v - knee * largest) / ((1.0 - knee) * largest) * (1.0 - knee_value);
}

// Strength of edges and of points: first and second derivatives of a Gaussian whose derivative's
// extrema are 0.082 degrees apart; section 4.2.
struct Features {
  Plane edge, point;
};

// Positive weights made to add up to 1 and negative ones to -1.
Kernel balanced(Kernel kernel) {
  double positive = 0.0, negative = 0.0;
  for (const float v : kernel)
    (v > 0.0f ? positive : negative) += v;
  for (float& v : kernel)
    v = static_cast<float>(v / (v > 0.0f ? positive : -negative));
  return kernel;
}

Plane magnitude(const Plane& a, const Plane& b) {
  Plane result = a;
  for (std::size_t i = 0; i < result.values.size(); ++i)
    result.values[i] = std::hypot(a.values[i], b.values[i]);
  return result;
}

Features features(const Plane& luminance) {
  constexpr double width = 0.082;
  const double sigma = 0.5 * width * pixels_per_degree;
  const int radius = static_cast<int>(std::ceil(3.0 * sigma));
  Kernel smooth, first, second;
  for (int x = -radius; x <= radius; ++x) {
    const double g = std::exp(-x * x / (2.0 * sigma * sigma));
    smooth.push_back(static_cast<float>(g));
    first.push_back(static_cast<float>(-x * g));
    second.push_back(static_cast<float>((x * x / (sigma * sigma) - 1.0) * g));
  }
  smooth = scaled(smooth, 1.0 / sum(smooth));
  first = balanced(first);
  second = balanced(second);
  return {.edge = magnitude(convolve(luminance, first, smooth), convolve(luminance, smooth, first)),
          .point =
              magnitude(convolve(luminance, second, smooth), convolve(luminance, smooth, second))};
}

Features features_of(const Planes& planes) {
  Plane luminance = planes[0];
  for (float& v : luminance.values)
    v = (v + 16.0f) / 116.0f;
  return features(luminance);
}

} // namespace

Image flip(const Image& test, const Image& reference) {
  Planes t = ycxcz_planes(test), r = ycxcz_planes(reference);
  const Features of_test = features_of(t), of_reference = features_of(r);
  for (std::size_t c = 0; c < 3; ++c) {
    t[c] = filtered(t[c], sensitivities[c]);
    r[c] = filtered(r[c], sensitivities[c]);
  }
  Image map(test.width, test.height, 1);
  for (std::size_t i = 0; i < map.values.size(); ++i) {
    const double colour = redistributed(hyab(perceived(t, i), perceived(r, i)));
    const double edge = std::abs(of_test.edge.values[i] - of_reference.edge.values[i]);
    const double point = std::abs(of_test.point.values[i] - of_reference.point.values[i]);
    const double feature = std::sqrt(std::max(edge, point) / std::numbers::sqrt2);
    // Features raise the colour difference that is there; section 4.3.
    map.values[i] = static_cast<float>(std::pow(colour, 1.0 - std::min(feature, 1.0)));
  }
  return map;
}

} // namespace gg::image
