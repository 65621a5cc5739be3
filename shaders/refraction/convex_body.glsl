// convex_body.glsl: where a ray leaves a convex body of which only the near face is drawn: thickness and curvature are known.
// Frame    any; n unit, outward, at the near face; direction unit, inside: dot(n, direction) < 0. Lengths in metres.
// alpha    width of the back face, [0, 1].
// Returns  convexExit: path, metres > 0 where the body has a thickness, and the surface there (composition_view.glsl).
// Source   the body is a lens of two faces of equal curvature, `thickness` apart along n: 0 is a plate, 2 / thickness a sphere.
//          Ray against sphere; written so that both ends are exact.
// Limits   thickness is along the normal, as in KHR_materials_volume. Curvature is clamped to [0, 2 / thickness]: what is hollow
//          is taken for flat.
#ifndef GG_REFRACTION_CONVEX_BODY_GLSL
#define GG_REFRACTION_CONVEX_BODY_GLSL

#include "refraction/composition_view.glsl"

struct ConvexBody {
  float ior; // n_inside / n_outside > 0
  float backAlpha;
  float thickness;
  float curvature; // 1/m
  vec3 attenuation; // absorption coefficient, 1/m
};

struct ConvexExit {
  ExitSurface surface;
  float path;
};

// With R = 1 / curvature the far sphere's centre is at (R - thickness) n; q is the thickness in units of R.
ConvexExit convexExit(vec3 n, vec3 direction, ConvexBody body) {
  float q = clamp(body.thickness * body.curvature, 0.0, 2.0);
  // A ray along a plate leaves it after 20 thicknesses: only an index below 1 bends one so far.
  float c = max(-dot(n, direction), 0.05);
  float a = (1.0 - q) * c;
  float root = sqrt(a * a + q * (2.0 - q));
  float scaled = q < 1.0 ? (2.0 - q) / (a + root) : (root - a) / q; // path / thickness
  ConvexExit e;
  e.path = scaled * body.thickness;
  e.surface.n = normalize((q - 1.0) * n + (q * scaled) * direction);
  e.surface.alpha = body.backAlpha;
  e.surface.eta = 1.0 / body.ior;
  float curvature = body.thickness > 0.0 ? q / body.thickness : 0.0;
  e.surface.turn = exitTurn(dot(direction, e.surface.n), e.path, vec2(curvature));
  return e;
}

#endif
