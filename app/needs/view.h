// From where and how a scene is drawn: what its needs depend on besides itself.
#pragma once

#include "needs/features.h"
#include "scene/scene.h"

#include <cstddef>
#include <optional>

namespace gg::needs {

struct View {
  scene::Camera camera;
  int width = 1280, height = 720;
  int samples = 16; // sub-pixel frames that are averaged
  Method method = Method::lobes1;
  bool correlated_smith = false, multiple_scattering = false;
  std::optional<std::size_t> environment; // bytes of its cubes; nothing: there is none
  FeatureSet without;                     // drawn as if nothing had these
};

// Of the frame whose samples are averaged, all of them within half a pixel of it.
glm::dmat4 clip_from_world(const View& view);

} // namespace gg::needs
