// front_back_refraction.glsl: rough refraction of a body whose back faces are drawn in a pass of their own: the second tier.
// Frame    world, metres. n outward on the viewer's side, wo to the viewer; unit.
// alpha    of the front face, [0, 1]; the back face's is what its pass says.
// Returns  refractFrontBack: as refractConvex. number: the body's, as engineFace (back_face_exit.glsl) tells it. wayOut: where
//          one lobe leaves the body by the faces of a layer.
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

// Past the critical angle all is reflected, and followed to the next back face, `reflections` times: a facet turns it by twice its
// tilt.
WayOut wayOut(vec3 origin, InnerLobe lobe, float eta, FaceLayer which, int reflections, SceneView view) {
  BackFaceExit seen = backFaceExit(origin, lobe.direction, 0.0, eta, which, view);
  WayOut way;
  way.lobe = lobe;
  way.exit = seen.exit;
  way.point = origin + seen.exit.path * lobe.direction;
  way.found = seen.found;
  for (int k = 0; k < reflections && seen.found; ++k) {
    float cosTheta = dot(way.lobe.direction, seen.exit.surface.n);
    if ((1.0 - cosTheta) * (1.0 + cosTheta) < eta * eta) break;
    vec3 onward = way.lobe.direction - 2.0 * cosTheta * seen.exit.surface.n;
    float alpha = seen.exit.surface.alpha;
    seen = backFaceExit(way.point, onward, 0.5 * seen.exit.path, eta, which, view);
    if (!seen.found) break;
    way.lobe.direction = onward;
    way.lobe.sigma = sqrt(way.lobe.sigma * way.lobe.sigma + 4.0 * alpha * alpha);
    way.lobe.weight *= engineFaceEnergy(cosTheta, alpha, eta).reflected;
    float before = way.exit.path;
    way.exit = seen.exit;
    way.exit.path = before + seen.exit.path;
    way.point += seen.exit.path * onward;
  }
  return way;
}

FaceLayer leavingFaces(int layer, float number) {
  FaceLayer which;
  which.layer = layer;
  which.side = 1.0;
  which.number = number;
  return which;
}

vec3 refractFrontBack(GlassFace face, ConvexBody body, float number, SceneView view, Widening k) {
  Entering entered = enterGlass(face, body.ior);
  WayOut core = wayOut(face.position, entered.core, 1.0 / body.ior, leavingFaces(BACK_FACES, number), 1, view);
  if (!core.found) return refractConvex(face, body, view, k);
  entered.core = core.lobe;
  WayOut tail = core;
  if (entered.tail.weight > 0.0) {
    tail = wayOut(face.position, entered.tail, 1.0 / body.ior, leavingFaces(BACK_FACES, number), 1, view);
    if (tail.found) entered.tail = tail.lobe;
    if (!tail.found) tail.exit = core.exit;
  }
  return refractThrough(face, body, entered, core.point, core.exit, tail.exit, view, k);
}

#endif
