// What is not glass: unlit, or lit by the environment alone. Stands for an engine's own shading.
#include "frame.glsl"
#include "draw.glsl"
#snippets lobe_table fresnel_schlick
GG_SAMPLER(2) sampler2D ggBaseColor;
GG_SAMPLER(3) sampler2D ggRoughness;
GG_VARYING(0) in vec3 vPosition;
GG_VARYING(1) in vec3 vNormal;
GG_VARYING(2) in vec2 vUv;
layout(location = 0) out vec4 pixel;
// Irradiance over pi. A cosine's lobe, whose mean squared tilt is pi^2 / 8 - 1/2, is flatter than one Gaussian: five of 0.4 radians,
// 0.643 from the normal, have that and its height in the middle to an eighth.
vec3 ggIrradiance(vec3 n) {
  vec3 t = normalize(cross(n, abs(n.y) < 0.7 ? vec3(0.0, 1.0, 0.0) : vec3(1.0, 0.0, 0.0)));
  vec3 b = cross(n, t);
  vec3 sum = vec3(0.0);
  for (int k = 0; k < 5; ++k) {
    float angle = 1.25663706 * float(k);
    sum += ggEnvironment(0.8 * n + 0.6 * (cos(angle) * t + sin(angle) * b), 0.4);
  }
  return 0.2 * sum;
}
void main() {
  vec3 color = ggColor.rgb * texture(ggBaseColor, vUv).rgb;
  pixel = vec4(color, 1.0);
  if (ggColor.a > 0.5) return;
  vec3 wo = normalize(ggEye.xyz - vPosition);
  vec3 n = normalize(vNormal);
  n = dot(n, wo) < 0.0 ? -n : n;
  vec4 surface = texture(ggRoughness, vUv);
  float roughness = ggSurface.x * surface.g;
  float metallic = ggSurface.y * surface.b;
  float cosTheta = max(dot(n, wo), 1e-3);
  float alpha = max(roughness * roughness, 1e-3);
  vec3 f0 = mix(vec3(0.04), color, metallic);
  vec3 f = f0 + (1.0 - f0) * pow(1.0 - cosTheta, 5.0) * (1.0 - roughness);
  vec4 lobe = textureLod(ggReflection, gg_lobeCoordinate(cosTheta, alpha, 0.0), 0.0);
  vec3 direction = gg_lobeDirection(2.0 * cosTheta * n - wo, n, lobe.x);
  pixel.rgb = f * ggEnvironment(direction, lobe.y * alpha) + (1.0 - metallic) * (1.0 - f) * color * ggIrradiance(n);
}
