// front_back_refraction.glsl: rough refraction of a body whose back faces are drawn in a pass of their own: the second tier.
// Frame    world, metres. n outward on the viewer's side, wo to the viewer; unit.
// alpha    of the front face, [0, 1]; the back face's is what its pass says.
// Returns  refractFrontBack: as refractConvex. number: the body's, as engineBackFace (back_face_exit.glsl) tells it.
// Source   back_face_exit.glsl, convex_refraction.glsl.
// Limits   those of both; where no back face is found the body is taken for convex_body.glsl's lens.
//          10 reads of tables, at most 8 of back faces, up to 21 of depth, 2 of the scene's colour, up to 3 of the environment.
#ifndef GG_REFRACTION_FRONT_BACK_REFRACTION_GLSL
#define GG_REFRACTION_FRONT_BACK_REFRACTION_GLSL

#include "refraction/back_face_exit.glsl"
#include "refraction/convex_refraction.glsl"

vec3 refractFrontBack(GlassFace face, ConvexBody body, float number, SceneView view, Widening k) {
  Entering entered = enterGlass(face, body.ior);
  BackFaceExit seen = backFaceExit(face.position, entered.core.direction, 1.0 / body.ior, number, view);
  if (seen.found) return refractThrough(face, body, entered, seen.exit, seen.exit, view, k);
  return refractThrough(face, body, entered, convexExit(face.n, entered.core.direction, body), convexExit(face.n, entered.tail.direction, body), view, k);
}

#endif
