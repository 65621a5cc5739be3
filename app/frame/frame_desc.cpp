#include "frame/frame_desc.h"

#include "environment/stack.h"
#include "needs/needs.h"
#include "uniforms/camera.h"

#include <cmath>

namespace gg::frame {

needs::View view_of(const FrameDesc& desc) {
  needs::View view{.camera = desc.camera,
                   .width = desc.width,
                   .height = desc.height,
                   .samples = desc.samples,
                   .method = desc.method,
                   .correlated_smith = desc.correlated_smith,
                   .multiple_scattering = desc.multiple_scattering,
                   .environment = {},
                   .without = desc.without};
  if (const environment::Stack* stack = desc.environment.stack)
    view.environment =
        bytes(stack->even->desc) + bytes(stack->odd->desc) + bytes(stack->irradiance->desc);
  return view;
}

std::vector<uniforms::FrameData> frame_blocks(const FrameDesc& desc, const needs::Needs& needs,
                                              int pyramid_levels) {
  const scene::Camera& camera = desc.camera;
  const double aspect = static_cast<double>(desc.width) / desc.height;
  uniforms::FrameData f{};
  f.eye = glm::vec4(glm::vec3(camera.world[3]), camera.orthographic ? 0.0f : 1.0f);
  f.viewDirection = glm::vec4(-glm::normalize(glm::vec3(camera.world[2])), 0.0f);
  f.environment = {std::cos(desc.environment.rotation), std::sin(desc.environment.rotation),
                   desc.environment.intensity, 0.0f};
  if (desc.environment.stack) f.stack = desc.environment.stack->shape;
  const Background& behind = desc.background;
  f.background = behind.plain ? glm::vec4(*behind.plain, -1.0f) : glm::vec4(0, 0, 0, behind.sigma);
  if (desc.environment.stack && needs.proxies) {
    const environment::Sun& sun = desc.environment.stack->sun;
    const double c = std::cos(desc.environment.rotation), s = std::sin(desc.environment.rotation);
    const glm::dvec3& d = sun.direction; // back from the map: inEnvironment's inverse
    f.sunDirection = glm::vec4(c * d.x + s * d.z, d.y, c * d.z - s * d.x, sun.sigma);
    f.sunIrradiance =
        glm::vec4(static_cast<double>(desc.environment.intensity) * sun.irradiance, 0.0);
  }
  f.picture = {desc.width, desc.height,
               0.5 * uniforms::clip_from_view(camera, aspect)[1][1] * desc.height,
               pyramid_levels - 1};
  f.boundsLow = glm::vec4(needs.bounds.low, 0.0f);
  f.boundsHigh = glm::vec4(needs.bounds.high, 0.0f);
  f.counts = {static_cast<int>(needs.scene->lights.size()), static_cast<int>(needs.walls.size()), 0,
              0};
  for (std::size_t w = 0; w < needs.walls.size(); ++w) {
    const needs::Wall& wall = needs.walls[w];
    f.walls[3 * w] = glm::vec4(wall.centre, 0.0f);
    f.walls[3 * w + 1] = glm::vec4(wall.gradient_u, 0.0f);
    f.walls[3 * w + 2] = glm::vec4(wall.gradient_v, 0.0f);
  }
  const glm::dmat4 clip_from_world = needs::clip_from_world(needs.view);
  std::vector<uniforms::FrameData> blocks(static_cast<std::size_t>(desc.samples), f);
  for (int i = 0; i < desc.samples; ++i) {
    uniforms::FrameData& block = blocks[static_cast<std::size_t>(i)];
    const glm::dvec2 at = uniforms::sample_position(i, desc.samples);
    const glm::dmat4 clip =
        uniforms::offset_by_pixels(at.x, at.y, desc.width, desc.height) * clip_from_world;
    block.clipFromWorld = glm::mat4(clip);
    block.worldFromClip = glm::mat4(glm::inverse(clip));
    // Of a square of 1 / samples of the pixel's area: a twelfth of that.
    block.part = glm::vec4(glm::vec3(uniforms::lobe_stratum(i, desc.samples)),
                           1.0f / (12.0f * static_cast<float>(desc.samples)));
  }
  return blocks;
}

} // namespace gg::frame
