// back_face.glsl: the faces of glass as passes show them, a texel each.
// Frame    world, metres; pixels as engine.glsl; n out of the body.
// alpha    of the face, [0, 1].
// Returns  backFaceAt: point, normal along rays that leave (side 1) or enter (-1), alpha and body of a texel. backFaceBeside: the
//          same of a neighbour on the same smooth surface, or the texel itself. pixelSteps: what moves a place by a pixel.
//          engineFace, an engine's to supply: of a layer of glass at a place, nearest texel: xy octEncode of its outward normal,
//          z metres along the camera's axis, w its body's number, from 1, plus half of alpha; 0 where there is no face.
// Source   [Wyman05].
// Limits   perspective cameras only; a texel's face is the plane through its middle. One read each.
#ifndef GG_REFRACTION_BACK_FACE_GLSL
#define GG_REFRACTION_BACK_FACE_GLSL

#include "refraction/exit_search.glsl"
#include "refraction/scene_intersection.glsl"

vec4 engineFace(int layer, vec2 at);

const int BACK_FACES = 0;    // the nearest
const int SECOND_FRONTS = 1; // the nearest front faces behind those: two_pair_refraction.glsl alone asks for them,
const int SECOND_BACKS = 2;  // and for the nearest back faces behind these

// Which faces a ray may meet.
struct FaceLayer {
  int layer;
  float side;   // 1: faces that a ray inside leaves by; -1: that a ray outside enters by
  float number; // of their body; below 0: any
};

struct BackFace {
  vec3 point;
  vec3 n; // outward where rays leave, inward where they enter
  float alpha;
  float number;
  bool exists; // it is of the body asked for
};

// What moves a place by one pixel to the right and down, metres per metre along the camera's axis.
struct PixelSteps {
  vec3 right;
  vec3 down;
};

PixelSteps pixelSteps(SceneView view) {
  vec3 forward = vec3(view.clipFromWorld[0][3], view.clipFromWorld[1][3], view.clipFromWorld[2][3]);
  vec3 x = vec3(view.clipFromWorld[0][0], view.clipFromWorld[1][0], view.clipFromWorld[2][0]);
  vec3 y = vec3(view.clipFromWorld[0][1], view.clipFromWorld[1][1], view.clipFromWorld[2][1]);
  x -= dot(x, forward) * forward; // a picture's middle off the axis is no part of its scale
  y -= dot(y, forward) * forward;
  PixelSteps steps;
  steps.right = 2.0 / (view.size.x * dot(x, x)) * x;
  steps.down = -2.0 / (view.size.y * dot(y, y)) * y;
  return steps;
}

// The surface that the texel at `at` shows at its middle. p: any point that is seen at `at`, from the eye, over its metres along
// the axis.
BackFace backFaceAt(vec2 at, vec3 p, FaceLayer which, PixelSteps steps, SceneView view) {
  vec4 texel = engineFace(which.layer, at);
  vec2 off = floor(at) + 0.5 - at;
  BackFace face;
  face.point = view.eye + texel.z * (p + off.x * steps.right + off.y * steps.down);
  face.n = which.side * octDecode(vec2(texel.x, texel.y));
  face.alpha = 2.0 * fract(texel.w);
  face.number = floor(texel.w);
  face.exists = which.number < 0.0 ? face.number > 0.0 : face.number == which.number;
  return face;
}

// A neighbour of a texel, if both belong to one smooth surface; else the texel itself, which says that nothing turns.
BackFace backFaceBeside(BackFace own, vec2 at, vec3 p, FaceLayer which, PixelSteps steps, SceneView view) {
  BackFace beside = backFaceAt(at, p, which, steps, view);
  if (beside.exists && exitSame(own.point, own.n, beside.point, beside.n)) return beside;
  return own;
}

#endif
