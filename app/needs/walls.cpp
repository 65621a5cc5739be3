#include "needs/walls.h"

#include "needs/flat.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace gg::needs {
namespace {

constexpr double filled = 0.02; // of its area: what may be missing, or lie double

double area_of(const scene::Scene& scene, const scene::Primitive& primitive) {
  const std::vector<float>& values =
      scene.streams[static_cast<std::size_t>(primitive.positions)].values;
  const scene::Indices& indices = scene.indices[static_cast<std::size_t>(primitive.indices)];
  const auto point = [&](std::size_t i) {
    const std::size_t k = 3 * static_cast<std::size_t>(indices[i]);
    return glm::dvec3(values[k], values[k + 1], values[k + 2]);
  };
  double area = 0.0;
  for (std::size_t i = 0; i + 2 < indices.size(); i += 3)
    area += 0.5 * glm::length(glm::cross(point(i + 1) - point(i), point(i + 2) - point(i)));
  return area;
}

std::optional<Wall> wall_of(const scene::Scene& scene, const Draw& draw, const glm::mat4& world) {
  if (draw.role != Role::opaque || draw.material->alpha_mode != scene::AlphaMode::opaque) return {};
  const scene::Bounds& box = draw.primitive->bounds;
  if (box.empty()) return {};
  const glm::vec3 size = box.high - box.low;
  const int thin = size.x <= size.y && size.x <= size.z ? 0 : size.y <= size.z ? 1 : 2;
  const int a = (thin + 1) % 3, b = (thin + 2) % 3;
  const double rectangle = static_cast<double>(size[a]) * size[b];
  if (!(rectangle > 0.0)
      || size[thin] > static_cast<float>(flat_below) * std::max(size[a], size[b]))
    return {};
  if (std::abs(area_of(scene, *draw.primitive) - rectangle) > filled * rectangle) return {};

  glm::vec3 half_a(0.0f), half_b(0.0f);
  half_a[a] = 0.5f * size[a];
  half_b[b] = 0.5f * size[b];
  const glm::vec3 u = glm::mat3(world) * half_a, v = glm::mat3(world) * half_b;
  const glm::vec3 n = glm::cross(u, v);
  const float square = glm::dot(n, n);
  if (!(square > 0.0f)) return {};
  return Wall{glm::vec3(world * glm::vec4(box.centre(), 1.0f)), glm::cross(v, n) / square,
              glm::cross(n, u) / square, 4.0f * std::sqrt(square)};
}

} // namespace

std::vector<Wall> walls_of(const scene::Scene& scene, const Draws& draws) {
  std::vector<Wall> walls;
  for (const Draw& draw : draws.all)
    if (const auto wall = wall_of(scene, draw, draws.instances[draw.instance_index]->world))
      walls.push_back(*wall);
  std::ranges::stable_sort(walls, std::greater{}, &Wall::area);
  walls.resize(std::min(walls.size(), most_walls));
  return walls;
}

} // namespace gg::needs
