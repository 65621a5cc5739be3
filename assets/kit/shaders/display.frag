// Linear radiance as a display shows it: sRGB.
#include "pass.glsl"
#snippets srgb
GG_VARYING(0) in vec2 vPlace;
layout(location = 0) out vec4 pixel;
void main() {
  vec3 c = min(textureLod(ggSource, vPlace, 0.0).rgb, 1.0);
  pixel = vec4(gg_srgbFromLinear(c.r), gg_srgbFromLinear(c.g), gg_srgbFromLinear(c.b), 1.0);
}
