// From linear radiance to what a display shows.
#pragma once

#include "image/image.h"

#include <string>

namespace gg::frame {

enum class ToneMap { none, neutral, aces, agx };

// "none", "neutral", "aces" or "agx"; else Error(usage).
ToneMap parse_tone_map(const std::string& name);

// Multiplies by 2^exposure, applies the tone curve and the sRGB transfer function: RGB in 0..1 for
// an 8-bit file. Alpha is dropped: a picture of a scene has no holes. `none` clamps only.
image::Image for_display(const image::Image& radiance, float exposure, ToneMap tone_map);

} // namespace gg::frame
