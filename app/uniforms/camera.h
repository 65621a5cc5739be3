// From a scene's camera to the matrices of a frame.
#pragma once

#include "scene/scene.h"

namespace gg::uniforms {

// Clip space of app/gpu/types.h with reversed depth: 1 at the near plane, 0 at the far plane or at
// infinity, where floating point then has its digits (depth is about near / distance). `aspect` is
// width / height of the picture; the vertical field of view is kept.
glm::dmat4 clip_from_view(const scene::Camera& camera, double aspect);
glm::dmat4 view_from_world(const scene::Camera& camera);

// Moves the picture by (x, y) pixels of a width x height target: the sample at (x, y) lands on the
// pixel's centre. x to the right, y down.
glm::dmat4 offset_by_pixels(double x, double y, int width, int height);

// The i-th of `count` sample positions in a pixel, each coordinate in [-1/2, 1/2): the Hammersley
// set (i + 1/2) / n and radical inverse of i in base 2, shifted so that its mean is the pixel's
// centre. One sample is the centre itself.
glm::dvec2 sample_position(int i, int count);

// The part of every lobe of light that the i-th of `count` samples of a pixel stands for, as
// shaders/refraction/lobe_stratum.glsl has it: xy in sigmas, z the share of the width kept. Over all
// samples xy has the mean 0 and the variance 1 - z² along each axis, to rounding: together they are
// the whole lobe. Fewer than three cannot be: each is the whole lobe then.
glm::dvec3 lobe_stratum(int i, int count);

} // namespace gg::uniforms
