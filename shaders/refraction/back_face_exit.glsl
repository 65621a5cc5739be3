// back_face_exit.glsl: where a ray meets a face of glass, seen only through passes of the faces' depth and normals.
// Frame    world, metres; pixels as engine.glsl; n out of the body; direction unit, inside.
// alpha    of the face met, [0, 1].
// Returns  backFaceExit: surface and path as convexExit; found false: the faces show none that the ray meets, the rest is 0.
//          surface.n along the ray.
// Source   [Wyman05]; Newton's steps on the planes that texels show, as exit_search.glsl's.
// Limits   one back face: of a body that is not convex the ray leaves by the nearest. Perspective cameras only. At most 8 reads.
#ifndef GG_REFRACTION_BACK_FACE_EXIT_GLSL
#define GG_REFRACTION_BACK_FACE_EXIT_GLSL

#include "refraction/back_face.glsl"
#include "refraction/convex_body.glsl"
#include "refraction/exit_search.glsl"
#include "refraction/scene_intersection.glsl"

const int BACK_FACE_STEPS = 6;

struct BackFaceExit {
  ConvexExit exit;
  float number; // of the body met
  bool found;
};

// The normal between texels, at the place `hit` within a pixel of `at`, and how the surface curves there.
BackFaceExit backFaceBetween(BackFace face, vec2 at, vec2 hit, vec3 p, FaceLayer which, vec3 origin, vec3 direction,
                             PixelSteps steps, SceneView view) {
  BackFace right = backFaceBeside(face, at + vec2(1.0, 0.0), p + steps.right, which, steps, view);
  BackFace below = backFaceBeside(face, at + vec2(0.0, 1.0), p + steps.down, which, steps, view);
  vec2 off = hit - floor(at) - 0.5;
  BackFaceExit found;
  found.exit.surface.n = normalize(face.n + off.x * (right.n - face.n) + off.y * (below.n - face.n));
  found.exit.surface.alpha = face.alpha;
  found.exit.path = exitPlane(origin, direction, face.point, face.n);
  found.number = face.number;
  float cosTheta = dot(direction, found.exit.surface.n);
  vec2 curvature = exitCurvature(face.n, direction, right.point - face.point, right.n - face.n, below.point - face.point,
                                 below.n - face.n);
  found.exit.surface.turn = exitTurn(cosTheta, found.exit.path, curvature);
  found.found = cosTheta > 0.0;
  return found;
}

BackFaceExit noBackFace(vec3 direction, float eta) {
  BackFaceExit none;
  none.exit.surface.n = direction;
  none.exit.surface.alpha = 0.0;
  none.exit.surface.turn = vec2(0.0);
  none.exit.surface.eta = eta;
  none.exit.path = 0.0;
  none.number = 0.0;
  none.found = false;
  return none;
}

// From the back face behind the pixel on to the plane that is seen where the ray meets it, until the next is the same.
// first: how far along the ray to begin, metres: 0 on the front face. The loop holds one read alone: where pixels that are drawn
// together leave it at different steps, all wait for what it holds.
BackFaceExit backFaceExit(vec3 origin, vec3 direction, float first, float eta, FaceLayer which, SceneView view) {
  vec4 from = view.clipFromWorld * vec4(origin, 1.0);
  vec4 along = view.clipFromWorld * vec4(direction, 0.0);
  PixelSteps steps = pixelSteps(view);
  float inside = 0.0; // the farthest place where the body was seen behind the ray
  float t = first;
  BackFace face;
  vec2 at = vec2(0.0);
  vec2 hit = vec2(0.0);
  vec3 p = vec3(0.0);
  bool found = false;
  bool lost = false;
  for (int k = 0; k < BACK_FACE_STEPS && !found && !lost; ++k) {
    vec4 clip = from + t * along;
    at = scenePixel(clip, view.size);
    vec3 here = origin + t * direction;
    p = (here - view.eye) / clip.w;
    face = backFaceAt(at, p, which, steps, view);
    float met = exitPlane(origin, direction, face.point, face.n);
    bool meets = face.exists && dot(direction, face.n) > 0.0 && met > 0.0;
    lost = !(clip.w > 0.0) || (k == 0 && !face.exists);
    vec4 there = from + met * along;
    hit = scenePixel(there, view.size);
    vec2 moved = hit - at;
    found = !lost && meets && there.w > 0.0 && dot(moved, moved) < 0.5;
    // Not met at first: as far as the body is deep behind the pixel; then: back from past the outline.
    float missed = k == 0 ? length(face.point - here) : 0.5 * (inside + t);
    inside = meets ? t : inside;
    t = meets ? met : missed;
  }
  if (!found) return noBackFace(direction, eta);
  BackFaceExit exit = backFaceBetween(face, at, hit, p, which, origin, direction, steps, view);
  exit.exit.surface.eta = eta;
  return exit;
}

#endif
