#include "frame/display.h"

#include "core/error.h"
#include "glsl/f32.h"

#include <cmath>

namespace gg::frame {
namespace {

namespace f32 = glsl::f32;

glm::vec3 curve(const glm::vec3& radiance, ToneMap tone_map) {
  switch (tone_map) {
  case ToneMap::none:
    return glm::clamp(radiance, 0.0f, 1.0f);
  case ToneMap::neutral:
    return f32::tonemapNeutral(radiance);
  case ToneMap::aces:
    return f32::tonemapAces(radiance);
  case ToneMap::agx:
    return f32::tonemapAgx(radiance);
  }
  return radiance;
}

} // namespace

ToneMap parse_tone_map(const std::string& name) {
  if (name == "none") return ToneMap::none;
  if (name == "neutral") return ToneMap::neutral;
  if (name == "aces") return ToneMap::aces;
  if (name == "agx") return ToneMap::agx;
  throw Error(ExitCode::usage, "--tonemap", "'" + name + "' is not known",
              "Choose none, neutral, aces or agx.");
}

image::Image for_display(const image::Image& radiance, float exposure, ToneMap tone_map) {
  const float factor = std::exp2(exposure);
  image::Image shown(radiance.width, radiance.height, 3);
  for (int y = 0; y < radiance.height; ++y)
    for (int x = 0; x < radiance.width; ++x) {
      const glm::vec3 scene(radiance.at(x, y, 0), radiance.at(x, y, 1), radiance.at(x, y, 2));
      const glm::vec3 display = f32::srgbFromLinearRgb(curve(factor * scene, tone_map));
      for (int c = 0; c < 3; ++c)
        shown.at(x, y, c) = display[c];
    }
  return shown;
}

} // namespace gg::frame
