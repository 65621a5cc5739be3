#include "needs/outline.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gg::needs {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

const std::array<glm::dvec2, Outline::directions>& axes() {
  static const auto all = [] {
    std::array<glm::dvec2, Outline::directions> axes;
    for (std::size_t k = 0; k < axes.size(); ++k) {
      const double angle = std::numbers::pi * static_cast<double>(k) / Outline::directions;
      axes[k] = {std::cos(angle), std::sin(angle)};
    }
    return axes;
  }();
  return all;
}

} // namespace

Outline::Outline() {
  low.fill(infinity);
  high.fill(-infinity);
}

void Outline::include(const glm::dvec2& place) {
  for (std::size_t k = 0; k < directions; ++k) {
    const double at = glm::dot(axes()[k], place);
    low[k] = std::min(low[k], at);
    high[k] = std::max(high[k], at);
  }
}

void Outline::include_everything() {
  low.fill(-infinity);
  high.fill(infinity);
}

void Outline::include(const Outline& other) {
  for (std::size_t k = 0; k < directions; ++k) {
    low[k] = std::min(low[k], other.low[k]);
    high[k] = std::max(high[k], other.high[k]);
  }
}

bool Outline::overlaps(const Outline& other) const {
  for (std::size_t k = 0; k < directions; ++k)
    if (low[k] >= other.high[k] || other.low[k] >= high[k]) return false;
  return true;
}

Outline outline_of(const scene::Scene& scene, const Draw& draw, const scene::Instance& instance,
                   const glm::dmat4& clip_from_world) {
  const glm::dmat4 clip_from_mesh = clip_from_world * glm::dmat4(instance.world);
  const std::vector<float>& values =
      scene.streams[static_cast<std::size_t>(draw.primitive->positions)].values;
  const std::vector<std::uint32_t>& indices =
      scene.indices[static_cast<std::size_t>(draw.primitive->indices)];
  // Many primitives may share one long stream.
  const bool by_index = indices.size() < values.size() / 3;
  Outline outline;
  for (std::size_t i = 0; i < (by_index ? indices.size() : values.size() / 3); ++i) {
    const std::size_t v = 3 * (by_index ? indices[i] : i);
    const glm::dvec4 clip =
        clip_from_mesh * glm::dvec4(values[v], values[v + 1], values[v + 2], 1.0);
    if (!(clip.w > 0.0) || clip.z > clip.w) {
      outline.include_everything();
      return outline;
    }
    outline.include(glm::dvec2(clip) / clip.w);
  }
  return outline;
}

} // namespace gg::needs
