// scene_lookup.glsl: what a lobe that leaves glass brings: the scene's colour where it meets something that is seen, else the
// environment.
// Frame    world, metres; pixels as engine.glsl.
// alpha    none; sigma, inner, carried: radians.
// Returns  lobeRadiance: linear radiance of one lobe, >= 0.
// Source   scene_intersection.glsl, screen_pyramid.glsl for the blur.
// Limits   beyond the picture its border fades over one height of it into the environment. What a ray passes behind it meets,
//          blurred over as much as it is behind.
#ifndef GG_REFRACTION_SCENE_LOOKUP_GLSL
#define GG_REFRACTION_SCENE_LOOKUP_GLSL

#include "refraction/composition.glsl"
#include "refraction/scene_intersection.glsl"
#include "refraction/screen_pyramid.glsl"

// lobe leaves at origin, after `inside` metres in the glass.
vec3 lobeRadiance(ComposedLobe lobe, vec3 origin, float inside, SceneIntersection met, SceneView view) {
  bool ends = met.metres >= 0.0;
  vec3 place = ends ? origin + met.metres * lobe.direction : lobe.direction;
  vec4 clip = view.clipFromWorld * vec4(place, ends ? 1.0 : 0.0);
  float share = 0.0;
  vec3 near = vec3(0.0);
  if (met.seen && clip.w > 0.0) {
    vec3 fromEye = ends ? place - view.eye : lobe.direction;
    float range = length(fromEye);
    float metres = sqrt(lobeVariance(lobe.sigma, lobe.carried, lobe.inner, inside, met.metres) + met.behind * met.behind);
    float pixels = (ends ? metres / range : lobe.sigma) * pixelsPerRadian(view.focal, min(clip.w / range, 1.0));
    vec2 at = scenePixel(clip, view.size);
    vec2 outside = max(max(-at, at - view.size), vec2(0.0));
    float far = dot(outside, outside);
    share = ends ? exp(-0.5 * far / (view.size.y * view.size.y)) : pyramidCoverage(at, view.size, pixels);
    if (share > 0.0) {
      vec4 shown = engineSceneColor(at, pixels * pixels + far);
      share *= min(2.0 * shown.w, 1.0);
      near = shown.w > 0.0 ? vec3(shown.x, shown.y, shown.z) / shown.w : vec3(0.0);
    }
  }
  return share >= 0.999 ? near : mix(engineEnvironment(lobe.direction, lobe.sigma), near, share);
}

#endif
