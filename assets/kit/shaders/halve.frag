// The scene's pyramid of Gaussians: half of a picture, through [1 3 3 1] / 8 in both directions: four lookups between texels.
#include "pass.glsl"
GG_VARYING(0) in vec2 vPlace;
layout(location = 0) out vec4 pixel;
void main() {
  vec2 step = 0.75 / ggPass.xy; // of the source's width and height: 3 : 1 between two texels
  pixel = 0.25 * (textureLod(ggSource, vPlace + vec2(-step.x, -step.y), ggPass.z) + textureLod(ggSource, vPlace + vec2(step.x, -step.y), ggPass.z)
                  + textureLod(ggSource, vPlace + vec2(-step.x, step.y), ggPass.z) + textureLod(ggSource, vPlace + vec2(step.x, step.y), ggPass.z));
}
