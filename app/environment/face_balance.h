// What the texels of a cube's faces count for in a convolution, so that it keeps constants and the mean over the sphere.
#pragma once

#include <glm/vec4.hpp>

#include <span>
#include <vector>

namespace gg::environment {

// A row of weights that adds up to 1 keeps constants; to keep the mean, what a texel gives to all results must add up to its solid
// angle as well, which a lattice with edges does not grant (0.3 % at a face's edge, step after step). Each function returns the
// solid angles of one face's texels times a balance near 1, row by row; all faces are alike. The results divide by
// the sum of their weights.

// For environment_blur.comp on faces of `size` texels, with the step's `kernel` of environment_step.glsl.
std::vector<float> blur_weights(int size, const glm::vec4& kernel);

// For environment_zonal.comp from faces of `source_size` texels to such of `size`, with a kernel as zonal.h tabulates it.
std::vector<float> zonal_weights(int size, int source_size, std::span<const float> kernel);

} // namespace gg::environment
