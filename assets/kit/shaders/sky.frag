// The environment where nothing stands before it.
#include "frame.glsl"
GG_VARYING(0) in vec2 vPlace;
layout(location = 0) out vec4 pixel;
void main() {
  vec2 clip = 2.0 * vPlace - 1.0;
  pixel = vec4(ggEnvironment(ggForward.xyz + clip.x * ggRight.xyz + clip.y * ggUp.xyz, 0.0), 1.0);
}
