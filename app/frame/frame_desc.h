// What a frame is asked for, besides its scene.
#pragma once

#include "needs/features.h"
#include "needs/view.h"
#include "scene/scene.h"
#include "uniforms/blocks.h"

#include <vector>

namespace gg::environment {
struct Stack;
}
namespace gg::needs {
struct Needs;
}
namespace gg::frame {

using needs::Method;

// The light from all around. `stack` null: there is none.
struct EnvironmentView {
  const environment::Stack* stack = nullptr;
  float rotation = 0.0f;  // radians about +Y, counter-clockwise seen from above
  float intensity = 1.0f; // factor on its radiance
};

struct FrameDesc {
  int width = 1280, height = 720;
  int samples =
      16; // sub-pixel frames that are averaged: antialiasing with a box filter of one pixel
  scene::Camera camera;
  EnvironmentView environment;
  Method method = Method::lobes1;
  bool correlated_smith = false, multiple_scattering = false;
};

// What a scene's needs depend on.
needs::View view_of(const FrameDesc& desc);

// The block of each sample (shaders/interface/frame.glsl); `pyramid_levels` of the scene colour, 1 if it has no pyramid.
std::vector<uniforms::FrameData> frame_blocks(const FrameDesc& desc, const needs::Needs& needs,
                                              int pyramid_levels);

} // namespace gg::frame
