// front_back_refraction.glsl: rough refraction of a body whose back faces are drawn in a pass of their own: the second tier.
// Frame    world, metres. n outward on the viewer's side, wo to the viewer; unit.
// alpha    of the front face, [0, 1]; the back face's is what its pass says.
// Returns  refractFrontBack: as refractConvex. number: the body's, as engineFace (back_face_exit.glsl) tells it. wayOut: where
//          one lobe leaves the body by the faces of a layer.
// Source   back_face_exit.glsl, convex_refraction.glsl.
// Limits   those of both; where no back face is found the body is taken for convex_body.glsl's lens. One total internal
//          reflection is followed. 10 to 12 reads of tables, 3 to 16 of back faces, up to 21 of depth, 2 of the scene's colour and
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
  WayOut way;
  way.lobe = lobe;
  way.point = origin;
  way.exit = noBackFace(lobe.direction, eta).exit;
  way.found = false;
  InnerLobe onward = lobe;
  float first = 0.0; // where the search begins: after a reflection half as far as the last way
  for (int k = 0; k <= reflections; ++k) {
    BackFaceExit seen = backFaceExit(way.point, onward.direction, first, eta, which, view);
    if (!seen.found) break;
    float before = way.exit.path;
    way.lobe = onward;
    way.exit = seen.exit;
    way.exit.path = before + seen.exit.path;
    way.point += seen.exit.path * onward.direction;
    way.found = true;
    float cosTheta = dot(onward.direction, seen.exit.surface.n);
    if (k == reflections || (1.0 - cosTheta) * (1.0 + cosTheta) < eta * eta) break;
    float alpha = seen.exit.surface.alpha;
    onward.direction -= 2.0 * cosTheta * seen.exit.surface.n;
    onward.sigma = sqrt(onward.sigma * onward.sigma + 4.0 * alpha * alpha);
    onward.weight *= engineFaceEnergy(cosTheta, alpha, eta).reflected;
    first = 0.5 * seen.exit.path;
  }
  return way;
}

// Where no face is found: by the lens that convex_body.glsl takes the body for.
WayOut convexWayOut(GlassFace face, InnerLobe lobe, ConvexBody body) {
  WayOut way;
  way.lobe = lobe;
  way.exit = convexExit(face.n, lobe.direction, body);
  way.point = face.position + way.exit.path * lobe.direction;
  way.found = false;
  return way;
}

FaceLayer leavingFaces(int layer, float number) {
  FaceLayer which;
  which.layer = layer;
  which.side = 1.0;
  which.number = number;
  return which;
}

// Of both lobes, by the nearest back faces or, where they show none and `last` is SECOND_BACKS, by those behind: a ray that runs
// along a wall comes out on the far side of a hollow body. The tail leaves beside the core: by the same faces.
struct WaysOut {
  WayOut core;
  WayOut tail;
};

WaysOut waysOut(GlassFace face, ConvexBody body, Entering entered, int last, float number, int reflections, SceneView view) {
  WaysOut ways;
  ways.core = convexWayOut(face, entered.core, body);
  ways.tail = convexWayOut(face, entered.tail, body);
  for (int layer = BACK_FACES; layer <= last && !ways.core.found; layer += SECOND_BACKS - BACK_FACES) {
    WayOut seen = wayOut(face.position, entered.core, 1.0 / body.ior, leavingFaces(layer, number), reflections, view);
    if (seen.found) ways.core = seen;
  }
  if (ways.core.found) {
    InnerLobe core = ways.core.lobe;
    ways.tail = ways.core;
    ways.tail.lobe.direction = normalize(entered.tail.direction + core.direction - entered.core.direction);
    float widened = core.sigma * core.sigma - entered.core.sigma * entered.core.sigma;
    ways.tail.lobe.sigma = sqrt(entered.tail.sigma * entered.tail.sigma + max(widened, 0.0));
    ways.tail.lobe.weight = entered.core.weight > 0.0 ? entered.tail.weight * core.weight / entered.core.weight : 0.0;
  }
  return ways;
}

vec3 refractFrontBack(GlassFace face, ConvexBody body, float number, SceneView view, Widening k) {
  Entering entered = enterGlass(face, body.ior);
  WaysOut ways = waysOut(face, body, entered, BACK_FACES, number, 1, view);
  entered.core = ways.core.lobe;
  entered.tail = ways.tail.lobe;
  return refractThrough(face, body, entered, ways.core.point, ways.core.exit, ways.tail.exit, view, k);
}

#endif
