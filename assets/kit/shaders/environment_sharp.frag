// The sharpest level of the environment, from an equirectangular map whose first row is the zenith. ggPass: size of the tile.
#include "pass.glsl"
#include "octahedron.glsl"
GG_VARYING(0) in vec2 vPlace;
layout(location = 0) out vec4 pixel;
void main() {
  vec3 sum = vec3(0.0);
  for (int k = 0; k < 4; ++k) {
    vec3 d = ggHere(vPlace + (vec2(float(k & 1), float(k >> 1)) - 0.5) * 0.5 / (ggPass.x + 2.0), ggPass.x);
    sum += textureLod(ggSource, vec2(atan(d.z, d.x) * 0.15915494 + 0.5, 0.5 - asin(clamp(d.y, -1.0, 1.0)) * 0.31830989), 0.0).rgb;
  }
  pixel = vec4(min(0.25 * sum, 65504.0), 1.0); // the largest half float: a brighter sun would be infinite
}
