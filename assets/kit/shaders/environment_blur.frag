// A level of the environment from the one before, a Gaussian that widens its sigma. ggPass: size of the tile, sigma of the widening;
// ggFrom: size and first row of the source's tile, width and height of its atlas.
#include "pass.glsl"
#include "octahedron.glsl"
GG_VARYING(0) in vec2 vPlace;
layout(location = 0) out vec4 pixel;
vec3 ggRead(vec3 d) {
  d /= abs(d.x) + abs(d.y) + abs(d.z);
  vec2 p = d.y >= 0.0 ? d.xz : (1.0 - abs(d.zx)) * vec2(d.x < 0.0 ? -1.0 : 1.0, d.z < 0.0 ? -1.0 : 1.0);
  return textureLod(ggSource, (vec2(1.0, ggFrom.y + 1.0) + (0.5 + 0.5 * p) * ggFrom.x) / ggFrom.zw, 0.0).rgb;
}
void main() { // points of a Gaussian disc: radii at its quantiles, angles by the golden ratio
  vec3 n = ggHere(vPlace, ggPass.x);
  vec3 t = normalize(cross(n, abs(n.y) < 0.7 ? vec3(0.0, 1.0, 0.0) : vec3(1.0, 0.0, 0.0)));
  vec3 b = cross(n, t);
  vec3 sum = vec3(0.0);
  for (int k = 0; k < 48; ++k) {
    float angle = 2.39996323 * float(k);
    float r = ggPass.y * sqrt(-2.0 * log(1.0 - (float(k) + 0.5) / 48.0));
    sum += ggRead(cos(r) * n + sin(r) * (cos(angle) * t + sin(angle) * b));
  }
  pixel = vec4(sum / 48.0, 1.0);
}
