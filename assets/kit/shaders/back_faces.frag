// The nearest back faces of glass, into 32-bit floats: octahedral outward normal, metres along the camera's axis, and the body's number
// plus half of alpha. Depth test on, front faces culled, cleared to 0.
#include "frame.glsl"
#include "draw.glsl"
#snippets exit_surface
GG_SAMPLER(3) sampler2D ggRoughness;
GG_VARYING(0) in vec3 vPosition;
GG_VARYING(1) in vec3 vNormal;
GG_VARYING(2) in vec2 vUv;
layout(location = 0) out vec4 pixel;
void main() {
  float roughness = ggSurface.z < 0.0 ? ggSurface.x * texture(ggRoughness, vUv).g : ggSurface.z;
  float metres = (ggClipFromWorld * vec4(vPosition, 1.0)).w;
  pixel = vec4(gg_octEncode(normalize(vNormal)), metres, ggGlass.w + 0.5 * roughness * roughness);
}
