// Occlusion of a surface by its own body: in hollows the environment's light arrives by reflection at the body's walls.
#pragma once

#include "needs/proxies.h"
#include "scene/scene.h"

#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace gg::needs {

// Rays for each of three points of a triangle: fewer, down to eight, where a body would take more than `enough_rays` (about four
// seconds of one core; fewer show as streaks on smooth metal); none where eight would be more than `most_rays`.
inline constexpr int hollow_rays = 64;
inline constexpr std::size_t enough_rays = 6'000'000, most_rays = 12'000'000;

struct Hollows {
  // Of one component, at the vertices: interpolated, and then bounded to [0, 1], the share of the cosine lobe about the normal that
  // meets the body.
  std::vector<scene::Stream> streams;
  // Of primitives of instances (indices into the scene and its mesh) that have hollows, into `streams`.
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> of;
};

// Of the opaque surfaces of each body of the proxies, by Embree; the same for the same scene. What is convex has none, found by a
// few of its triangles.
Hollows hollows_of(const scene::Scene& scene, const Proxies& proxies);

} // namespace gg::needs
