// What a frame is asked for, besides its scene.
#pragma once

#include "needs/features.h"
#include "needs/view.h"
#include "scene/scene.h"
#include "uniforms/blocks.h"

#include <optional>
#include <vector>

namespace gg::environment {
struct Stack;
}
namespace gg::needs {
struct Needs;
}
namespace gg::frame {

using needs::Method;

// The environment. `stack` null: there is none.
struct EnvironmentView {
  const environment::Stack* stack = nullptr;
  float rotation = 0.0f;  // radians about +Y, counter-clockwise seen from above
  float intensity = 1.0f; // factor on its radiance
};

// What the camera sees where nothing was drawn, and what glass refracts of that. It lights nothing.
struct Background {
  float sigma = 0.0f;             // radians, of a Gaussian over the environment; 0: as it is
  std::optional<glm::vec3> plain; // radiance, in the environment's place
};

struct FrameDesc {
  int width = 1280, height = 720;
  int samples =
      16; // sub-pixel frames that are averaged: antialiasing with a box filter of one pixel
  scene::Camera camera;
  EnvironmentView environment;
  Method method = Method::lobes1;
  bool correlated_smith = false, multiple_scattering = false;
  needs::FeatureSet without;
  Background background; // of frames that have an environment
};

// What a scene's needs depend on.
needs::View view_of(const FrameDesc& desc);

// The block of each sample (shaders/interface/frame.glsl); `pyramid_levels` of the scene colour, 1 if it has no pyramid.
std::vector<uniforms::FrameData> frame_blocks(const FrameDesc& desc, const needs::Needs& needs,
                                              int pyramid_levels);

} // namespace gg::frame
