// A layer of faces of glass, into 32-bit floats: octahedral outward normal, metres along the camera's axis, and the body's number plus
// half of alpha. Depth test on, cleared to 0. This: the nearest back faces (front faces culled); second_fronts.frag: the nearest front
// faces behind those; second_backs.frag: the nearest back faces behind these.
#include "frame.glsl"
#include "draw.glsl"
#snippets exit_surface
#ifdef GG_BEFORE
GG_SAMPLER(GG_BEFORE_AT) sampler2D GG_BEFORE;
#endif
GG_SAMPLER(3) sampler2D ggRoughness;
GG_VARYING(0) in vec3 vPosition;
GG_VARYING(1) in vec3 vNormal;
GG_VARYING(2) in vec2 vUv;
layout(location = 0) out vec4 pixel;
void main() {
  float roughness = ggSurface.z < 0.0 ? ggSurface.x * texture(ggRoughness, vUv).g : ggSurface.z;
  float metres = (ggClipFromWorld * vec4(vPosition, 1.0)).w;
#ifdef GG_BEFORE
  // Two surfaces that touch differ by rounding alone: a millionth.
  if (metres <= 1.000001 * texelFetch(GG_BEFORE, ivec2(gl_FragCoord.xy), 0).z) discard;
#endif
  pixel = vec4(gg_octEncode(normalize(vNormal)), metres, ggGlass.w + 0.5 * roughness * roughness);
}
