#include "frame/shadow_blocks.h"

#include <algorithm>

namespace gg::frame {

static_assert(needs::most_shadow_views == uniforms::MOST_SHADOW_VIEWS);

std::vector<uniforms::FrameData> shadow_frames(const needs::ShadowMaps& maps) {
  std::vector<uniforms::FrameData> frames;
  for (const needs::ShadowView& view : maps.views) {
    uniforms::FrameData& f = frames.emplace_back(uniforms::FrameData{});
    f.clipFromWorld = glm::mat4(view.clip_from_world);
    f.worldFromClip = glm::mat4(glm::inverse(view.clip_from_world));
    f.eye = glm::vec4(view.eye, view.from_afar ? 0.0 : 1.0);
    f.viewDirection = glm::vec4(view.direction, 0.0);
    f.picture = {maps.size, maps.size, 1.0f, 0.0f};
    f.part = {0.0f, 0.0f, 1.0f, 0.0f};
  }
  return frames;
}

uniforms::ShadowsData shadows_block(const needs::ShadowMaps& maps) {
  uniforms::ShadowsData block{};
  for (std::size_t i = 0; i < maps.views.size(); ++i) {
    const glm::dmat4& m = maps.views[i].clip_from_world;
    uniforms::ShadowViewData& view = block.views[i];
    view.clipFromWorld = glm::mat4(m);
    view.worldFromClip = glm::mat4(glm::inverse(m));
    // A step across the light by a metre moves x / w by as much as this, and 2 / size of that is a texel; the wider of both.
    const glm::dvec3 along = maps.views[i].direction;
    const auto across = [&](int row) {
      const glm::dvec3 gradient(m[0][row], m[1][row], m[2][row]);
      return glm::length(gradient - glm::dot(gradient, along) * along);
    };
    const double least = std::min(across(0), across(1));
    view.texel = {2.0 / (maps.size * least), static_cast<double>(maps.size),
                  maps.views[i].from_afar ? 0.0 : 1.0, 0.0};
  }
  return block;
}

} // namespace gg::frame
