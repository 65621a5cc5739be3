// scene_intersection.glsl: where a ray meets the scene that the camera sees, by its depth.
// Frame    world, metres; pixels as engine.glsl.
// alpha    none.
// Returns  sceneIntersection: metres along the ray, and whether what is there is known. scenePixel: a place of the picture.
// Source   depth to depth, then steps that are even on the screen, then secants.
// Limits   what the camera does not see is not met: the picture's border is taken to go on beyond it. Perspective cameras only. At
//          most 4 + 12 + 5 reads of depth.
#ifndef GG_REFRACTION_SCENE_INTERSECTION_GLSL
#define GG_REFRACTION_SCENE_INTERSECTION_GLSL

#include "bsdf/constants.glsl"
#include "refraction/engine.glsl"

struct SceneView {
  mat4 clipFromWorld; // w: metres along the camera's axis
  vec3 eye;
  vec2 size;   // pixels
  float focal; // pixels per unit of tangent
  float reach; // metres beyond which there is nothing: the scene's extent
};

struct SceneIntersection {
  float metres; // along the ray; below 0: it meets nothing that is known
  float behind; // metres that the ray has passed behind what is seen there: how thick that is, nobody knows. 0 on its surface
  bool seen;    // false: the environment stands in
};

const int SCENE_GUESSES = 4;
const int SCENE_STEPS = 12;
const int SCENE_SECANTS = 5;

// Clip coordinates, w > 0 -> pixels.
vec2 scenePixel(vec4 clip, vec2 size) {
  return vec2((0.5 + 0.5 * clip.x / clip.w) * size.x, (0.5 - 0.5 * clip.y / clip.w) * size.y);
}

// From depth to depth: what was read is taken for a plane across the view, and read again where the ray meets that.
SceneIntersection sceneGuess(vec4 origin, vec4 along, SceneView view) {
  SceneIntersection met;
  met.seen = false;
  met.behind = 0.0;
  met.metres = -1.0;
  vec2 at = scenePixel(origin, view.size);
  for (int k = 0; k < SCENE_GUESSES && !met.seen; ++k) {
    float depth = engineSceneDepth(at);
    bool sky = depth > 1e29;
    met.metres = sky ? -1.0 : (depth - origin.w) / along.w;
    if (!(along.w > 0.0) || (!sky && met.metres < 0.0)) break;
    vec4 there = sky ? along : origin + met.metres * along;
    vec2 next = scenePixel(there, view.size);
    // Within a pixel the depth that was read is the depth there.
    met.seen = k > 0 && abs(next.x - at.x) < 1.0 && abs(next.y - at.y) < 1.0;
    at = next;
  }
  return met;
}

// The share of the way that stays on the picture and before the camera.
float sceneShown(vec4 origin, vec4 way) {
  vec4 room = max(vec4(origin.w - origin.x, origin.w + origin.x, origin.w - origin.y, origin.w + origin.y), vec4(0.0));
  vec4 loss = vec4(way.x - way.w, -way.x - way.w, way.y - way.w, -way.y - way.w);
  vec4 cut = min(room / max(max(loss, room), vec4(LEAST_DIVISOR)), vec4(1.0));
  float end = min(min(cut.x, cut.y), min(cut.z, cut.w));
  return min(end, 0.99 * origin.w / max(-way.w, 0.99 * origin.w));
}

// Even steps on the screen are even in 1 / w. Height: how much nearer the ray is than the scene, in 1 / w.
SceneIntersection sceneMarch(vec4 origin, vec4 along, SceneView view) {
  vec4 way = view.reach * along;
  float end = sceneShown(origin, way);
  vec4 to = origin + end * way;
  vec3 a = vec3(origin.x, origin.y, 1.0) / origin.w;
  vec3 b = vec3(to.x, to.y, 1.0) / to.w;
  SceneIntersection met;
  met.seen = false;
  met.behind = 0.0;
  met.metres = -1.0;
  float low = 0.0;
  float heightLow = 0.0;
  float high = 1.0;
  float heightHigh = 0.0;
  bool crossed = false;
  float depth = 0.0;
  for (int k = 1; k <= SCENE_STEPS && !crossed; ++k) {
    high = float(k) / float(SCENE_STEPS);
    vec3 p = mix(a, b, high);
    depth = engineSceneDepth(vec2((0.5 + 0.5 * p.x) * view.size.x, (0.5 - 0.5 * p.y) * view.size.y));
    heightHigh = p.z - 1.0 / depth;
    crossed = heightHigh < 0.0 && (k == 1 || heightLow >= 0.0);
    if (!crossed) {
      low = high;
      heightLow = heightHigh;
    }
  }
  if (!crossed) {
    // It leaves the picture before what the border shows, which is taken to go on as a plane across the view.
    float beyond = (depth - origin.w) / along.w;
    bool bordered = end < 1.0 && depth < 1e29 && heightHigh >= 0.0 && beyond > 0.0;
    met.metres = bordered ? beyond : -1.0;
    met.seen = bordered || (heightHigh >= 0.0 && depth > 1e29 && along.w > 0.0);
    return met;
  }
  float gap = max(heightLow - heightHigh, LEAST_DIVISOR);
  for (int k = 0; k < SCENE_SECANTS; ++k) {
    float share = k % 2 == 0 ? 0.5 : heightLow / max(heightLow - heightHigh, LEAST_DIVISOR);
    float u = mix(low, high, clamp(share, 0.0, 1.0));
    vec3 p = mix(a, b, u);
    depth = engineSceneDepth(vec2((0.5 + 0.5 * p.x) * view.size.x, (0.5 - 0.5 * p.y) * view.size.y));
    float height = p.z - 1.0 / depth;
    bool front = height >= 0.0;
    low = front ? u : low;
    heightLow = front ? height : heightLow;
    high = front ? high : u;
    heightHigh = front ? heightHigh : height;
  }
  float u = mix(low, high, heightLow / max(heightLow - heightHigh, LEAST_DIVISOR));
  float near = (1.0 - u) / origin.w;
  float far = u / to.w;
  met.metres = view.reach * end * far / (near + far);
  met.seen = true;
  bool surface = heightLow - heightHigh < 0.5 * gap || gap < 1e-6; // of the view's reach: rounding
  if (!surface) met.behind = max(1.0 / max(near + far, LEAST_DIVISOR) - depth, 0.0);
  return met;
}

SceneIntersection sceneIntersection(vec3 origin, vec3 direction, SceneView view) {
  vec4 from = view.clipFromWorld * vec4(origin, 1.0);
  vec4 along = view.clipFromWorld * vec4(direction, 0.0);
  SceneIntersection met = sceneGuess(from, along, view);
  if (!met.seen) met = sceneMarch(from, along, view);
  return met;
}

#endif
