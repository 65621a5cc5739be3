// LDR-FLIP: how different two pictures look when a viewer flips between them. P. Andersson,
// J. Nilsson, T. Akenine-Moller, M. Oskarsson, K. Astrom, M. D. Fairchild, "FLIP: A Difference
// Evaluator for Alternating Images", Proc. ACM Comput. Graph. Interact. Tech. 3(2), 2020.
#pragma once

#include "image/image.h"

namespace gg::image {

// How finely the eye sees the picture: the paper's viewing conditions, 0.7 m from a 0.7 m wide
// display of 3840 pixels.
inline constexpr double pixels_per_degree = 67.0;

// One channel: 0 (no difference seen) to 1 (as black against white). Both pictures are linear
// Rec. 709 of three or more channels (the first three count) and the same size; values are clamped
// to 0..1, as a display does. All must be finite.
Image flip(const Image& test, const Image& reference);

} // namespace gg::image
