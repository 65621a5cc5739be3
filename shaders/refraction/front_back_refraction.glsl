// front_back_refraction.glsl: rough refraction of a body whose back faces are drawn in a pass of their own: the second tier.
// Frame    world, metres. n outward on the viewer's side, wo to the viewer; unit.
// alpha    of the front face, [0, 1]; the back face's is what its pass says.
// Returns  refractFrontBack: as refractConvex. number: the body's, as engineBackFace (back_face_exit.glsl) tells it.
// Source   back_face_exit.glsl, convex_refraction.glsl.
// Limits   those of both; where no back face is found the body is taken for convex_body.glsl's lens. One total internal
//          reflection is followed. 10 to 12 reads of tables, 6 to 32 of back faces, up to 21 of depth, 2 of the scene's colour and
//          up to 3 of the environment.
#ifndef GG_REFRACTION_FRONT_BACK_REFRACTION_GLSL
#define GG_REFRACTION_FRONT_BACK_REFRACTION_GLSL

#include "refraction/back_face_exit.glsl"
#include "refraction/convex_refraction.glsl"

struct WayOut {
  InnerLobe lobe; // as it reaches the exit
  ConvexExit exit;
  vec3 point;
  bool found;
};

// Past the critical angle all is reflected, and followed once to the next back face: a facet turns it by twice its tilt.
WayOut wayOut(GlassFace face, InnerLobe lobe, float eta, float number, SceneView view) {
  BackFaceExit seen = backFaceExit(face.position, lobe.direction, 0.0, eta, number, view);
  WayOut way;
  way.lobe = lobe;
  way.exit = seen.exit;
  way.point = face.position + seen.exit.path * lobe.direction;
  way.found = seen.found;
  float cosTheta = dot(lobe.direction, seen.exit.surface.n);
  if (!seen.found || (1.0 - cosTheta) * (1.0 + cosTheta) < eta * eta) return way;
  vec3 onward = lobe.direction - 2.0 * cosTheta * seen.exit.surface.n;
  BackFaceExit next = backFaceExit(way.point, onward, 0.5 * seen.exit.path, eta, number, view);
  if (!next.found) return way;
  float alpha = seen.exit.surface.alpha;
  way.lobe.direction = onward;
  way.lobe.sigma = sqrt(lobe.sigma * lobe.sigma + 4.0 * alpha * alpha);
  way.lobe.weight = lobe.weight * engineFaceEnergy(cosTheta, alpha, eta).reflected;
  way.exit = next.exit;
  way.exit.path = seen.exit.path + next.exit.path;
  way.point += next.exit.path * onward;
  return way;
}

vec3 refractFrontBack(GlassFace face, ConvexBody body, float number, SceneView view, Widening k) {
  Entering entered = enterGlass(face, body.ior);
  WayOut core = wayOut(face, entered.core, 1.0 / body.ior, number, view);
  if (!core.found) return refractConvex(face, body, view, k);
  entered.core = core.lobe;
  WayOut tail = core;
  if (entered.tail.weight > 0.0) {
    tail = wayOut(face, entered.tail, 1.0 / body.ior, number, view);
    if (tail.found) entered.tail = tail.lobe;
    if (!tail.found) tail.exit = core.exit;
  }
  return refractThrough(face, body, entered, core.point, core.exit, tail.exit, view, k);
}

#endif
