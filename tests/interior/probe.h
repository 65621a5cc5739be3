// The search for exits on a device: interior layers are drawn, and every pixel follows one ray.
#pragma once

#include "gpu/device.h"
#include "scene/scene.h"

#include <glm/glm.hpp>

#include <map>
#include <string>
#include <vector>

namespace gg::test {

struct ProbeDesc {
  int width = 256, height = 256;
  int pairs = 1, bounces = 2;
  int shown = 0; // segment of the way that `met` tells about
  scene::Camera camera;
};

struct Found {
  static constexpr int nothing = -1, no_glass = -2, too_many = -3;
  glm::vec3 direction; // outside; inside where the way did not end outside
  int bounces;         // or one of the three above
  glm::vec3 met;       // where the shown segment ends
  float reads;         // places of the picture
  glm::vec2 curvature; // there
  float share, thickness;
};

struct ProbeResult {
  std::vector<Found> pixels;                      // from the top left
  std::map<std::string, double> ms;               // by pass, the shortest of `repeats`
  std::vector<std::vector<std::uint32_t>> layers; // texels, four numbers each
};

ProbeResult probe(gpu::Device& device, const scene::Scene& scene, const ProbeDesc& desc,
                  int repeats = 1);

} // namespace gg::test
