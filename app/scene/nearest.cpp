#include "scene/nearest.h"

#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <array>

namespace gg::scene {
namespace {

using Corners = std::array<glm::dvec3, 3>;

double distance_to_segment(const glm::dvec3& a, const glm::dvec3& b) {
  const glm::dvec3 along = b - a;
  const double square = glm::dot(along, along);
  const double t = square > 0.0 ? std::clamp(-glm::dot(a, along) / square, 0.0, 1.0) : 0.0;
  return glm::length(a + t * along);
}

// From the origin: to the plane where its foot lies inside, else to the nearest edge.
double distance_to_triangle(const Corners& c) {
  const glm::dvec3 normal = glm::cross(c[1] - c[0], c[2] - c[0]);
  const double area = glm::length(normal);
  const bool inside = area > 0.0 && glm::dot(glm::cross(c[0], c[1]), normal) >= 0.0
                      && glm::dot(glm::cross(c[1], c[2]), normal) >= 0.0
                      && glm::dot(glm::cross(c[2], c[0]), normal) >= 0.0;
  if (inside) return std::abs(glm::dot(c[0], normal)) / area;
  return std::min({distance_to_segment(c[0], c[1]), distance_to_segment(c[1], c[2]),
                   distance_to_segment(c[2], c[0])});
}

double clear_depth_of(const Corners& c, double limit) {
  constexpr double cosine = 0.25; // of 75.5 degrees
  const auto [least, most] = std::minmax({-c[0].z, -c[1].z, -c[2].z});
  if (most <= 0.0 || least >= limit) return limit;
  if (least > 0.0) return least;
  return std::max(least, cosine * distance_to_triangle(c));
}

} // namespace

float clear_depth(const Scene& scene, const Camera& camera, float limit) {
  double depth = limit;
  const glm::dmat4 view = glm::inverse(glm::dmat4(camera.world));
  for (const Instance& instance : scene.instances) {
    const glm::dmat4 to_view = view * glm::dmat4(instance.world);
    for (const Primitive& p : scene.meshes[static_cast<std::size_t>(instance.mesh)].primitives) {
      const float* const positions =
          scene.streams[static_cast<std::size_t>(p.positions)].values.data();
      const Indices& indices = scene.indices[static_cast<std::size_t>(p.indices)];
      for (std::size_t i = 0; i + 2 < indices.size(); i += 3) {
        Corners corners;
        for (std::size_t k = 0; k < 3; ++k)
          corners[k] = glm::dvec3(
              to_view
              * glm::dvec4(glm::make_vec3(positions + 3 * std::size_t{indices[i + k]}), 1.0));
        depth = std::min(depth, clear_depth_of(corners, depth));
      }
    }
  }
  return static_cast<float>(depth);
}

} // namespace gg::scene
