// Rough glass: refraction through both faces, and the front face's own reflection. glass_pairs.frag: through two pairs of faces.
#include "frame.glsl"
#include "draw.glsl"
#snippets two_pair_refraction
GG_SAMPLER(2) sampler2D ggBaseColor;
GG_SAMPLER(3) sampler2D ggRoughness;
GG_SAMPLER(11) sampler2D ggBackFaces;
#ifdef GG_TWO_PAIRS
GG_SAMPLER(12) sampler2D ggSecondFronts;
GG_SAMPLER(13) sampler2D ggSecondBacks;
#endif
GG_VARYING(0) in vec3 vPosition;
GG_VARYING(1) in vec3 vNormal;
GG_VARYING(2) in vec2 vUv;
layout(location = 0) out vec4 pixel;

vec4 gg_engineInterfaceEnergy(vec3 at) { return textureLod(ggEnergy, at, 0.0); }
vec4 gg_engineInterfaceLobe(vec3 at) { return textureLod(ggLobes, at, 0.0); }
vec4 gg_engineReflectionLobe(vec3 at) { return textureLod(ggReflection, at, 0.0); }
vec4 gg_engineSceneColor(vec2 at, float variance) {
  return vec4(textureLod(ggPyramid, ggPlace(at), gg_pyramidLevel(variance, ggPicture.w)).rgb, 1.0);
}
float gg_engineSceneDepth(vec2 at) { // depth 0 near, 1 far, not reversed
  float z = textureLod(ggDepth, clamp(ggPlace(at), 0.5 / ggPicture.xy, 1.0 - 0.5 / ggPicture.xy), 0.0).x;
  return z >= 1.0 ? 1e30 : ggRange.x * ggRange.y / (ggRange.y - z * (ggRange.y - ggRange.x));
}
vec4 gg_engineFace(int layer, vec2 at) {
#ifdef GG_TWO_PAIRS
  if (layer == gg_SECOND_FRONTS) return textureLod(ggSecondFronts, ggPlace(at), 0.0);
  if (layer == gg_SECOND_BACKS) return textureLod(ggSecondBacks, ggPlace(at), 0.0);
#endif
  return textureLod(ggBackFaces, ggPlace(at), 0.0);
}
vec3 gg_engineEnvironment(vec3 direction, float sigma) { return ggEnvironment(direction, sigma); }

void main() {
  gg_GlassFace face;
  face.position = vPosition;
  face.wo = normalize(ggEye.xyz - vPosition);
  vec3 shape = normalize(vNormal);
  // Interpolated normals may lean away from the viewer: no further than along the surface.
  face.n = normalize(shape + max(1e-3 - dot(shape, face.wo), 0.0) * face.wo);
  float roughness = ggSurface.x * texture(ggRoughness, vUv).g;
  face.alpha = roughness * roughness;
  vec3 alongX = dFdx(vPosition);
  vec3 alongY = dFdy(vPosition);
  vec3 turnX = dFdx(shape);
  vec3 turnY = dFdy(shape);
  face.turn = ggAtlas.w * (dot(turnX, turnX) + dot(turnY, turnY)) / 24.0; // evenly over a pixel: a twelfth of its width²
  // The mean of the normal curvatures along two directions of the surface.
  float bend = 0.5 * (dot(turnX, alongX) / max(dot(alongX, alongX), 1e-20) + dot(turnY, alongY) / max(dot(alongY, alongY), 1e-20));
  gg_ConvexBody body;
  body.ior = ggGlass.y;
  body.backAlpha = ggSurface.z < 0.0 ? face.alpha : ggSurface.z * ggSurface.z;
  // The thickness is along the normal, in the mesh's own units.
  vec3 local = vec3(dot(ggWorldFromMesh[0].xyz, face.n) / dot(ggWorldFromMesh[0].xyz, ggWorldFromMesh[0].xyz),
                    dot(ggWorldFromMesh[1].xyz, face.n) / dot(ggWorldFromMesh[1].xyz, ggWorldFromMesh[1].xyz),
                    dot(ggWorldFromMesh[2].xyz, face.n) / dot(ggWorldFromMesh[2].xyz, ggWorldFromMesh[2].xyz));
  body.thickness = ggGlass.z / max(length(local), 1e-20);
  body.curvature = ggSurface.w < 0.0 ? max(bend, 0.0) : ggSurface.w;
  body.attenuation = ggAbsorption.rgb;
  gg_SceneView view;
  view.clipFromWorld = ggClipFromWorld;
  view.eye = ggEye.xyz;
  view.size = ggPicture.xy;
  view.focal = ggPicture.z;
  view.reach = ggRange.z;
  vec3 color = ggColor.rgb * texture(ggBaseColor, vUv).rgb;
#ifdef GG_TWO_PAIRS
  vec3 through = color * gg_refractTwoPairs(face, body, ggGlass.w, view, gg_wideningGgx(2));
#else
  vec3 through = color * gg_refractFrontBack(face, body, ggGlass.w, view, gg_wideningGgx(2));
#endif
  pixel = vec4(through + gg_reflectGlass(face, body.ior, view), 1.0);
}
