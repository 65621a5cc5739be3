// exit_read_fetch.glsl: reads the surface at which a ray leaves glass, between the texels of an interior layer.
// Frame    world, metres; those of exit_surface.glsl and interior_fetch.glsl.
// alpha    ExitHit: width of D of the surface met, in [0, 1].
// Returns  exitRead: the surface that a layer shows about the ray's place at t, and where the ray meets it; found 0 if the
//          texels show none that the ray can meet there. Never NaN. exitNone: the hit that is none.
// Source   exit_search.glsl.
// Limits   what is narrower than a texel.
#ifndef GG_REFRACTION_EXIT_READ_FETCH_GLSL
#define GG_REFRACTION_EXIT_READ_FETCH_GLSL

#include "refraction/interior_fetch.glsl"

struct ExitHit {
  float found;    // share of the 2 x 2 texels read that show the solid: fades at its outline. 0: no surface was found
  vec3 point;     // where; if none was found, the last point known to be inside
  vec3 n;         // outward, unit: dot(direction, n) > 0
  float alpha;
  float distance; // metres along the ray
  vec2 curvature; // exitCurvature
  float reads;    // places of the picture that were read
};

ExitHit exitNone(vec3 point, vec3 direction) {
  ExitHit hit;
  hit.found = 0.0;
  hit.point = point;
  hit.n = direction;
  hit.alpha = 0.0;
  hit.distance = 0.0;
  hit.curvature = vec2(0.0);
  hit.reads = 0.0;
  return hit;
}

// Position and normal between the four texels about the ray's place at t, of those that belong to one surface.
ExitHit exitRead(usampler2DArray interior, int layer, InteriorView view, ExitRay ray, float solid, vec3 origin, vec3 direction,
                 float t) {
  ExitHit hit = exitNone(origin, direction);
  vec4 place = exitAt(ray, t);
  if (!exitOnPicture(view, place)) return hit;
  vec2 at = place.xy;
  vec2 corner = floor(at - 0.5);
  vec2 between = at - 0.5 - corner;
  uvec4 bits[4];
  InteriorSurface s[4];
  for (int k = 0; k < 4; ++k) {
    ivec2 texel = clamp(ivec2(corner) + ivec2(k & 1, k >> 1), ivec2(0), ivec2(view.size) - 1);
    bits[k] = texelFetch(interior, ivec3(texel, layer), 0);
    s[k] = interiorSurface(view, bits[k], texel);
  }
  // Where several surfaces show, the one that the steps have led to.
  float least = EXIT_FAR;
  InteriorSurface own = s[0];
  for (int k = 0; k < 4; ++k) {
    if (interiorNumber(bits[k]) != solid || dot(direction, s[k].n) <= 0.0) continue;
    float apart = abs(exitPlane(origin, direction, s[k].point, s[k].n) - t);
    if (apart < least) {
      least = apart;
      own = s[k];
    }
  }
  if (least == EXIT_FAR) return hit;
  vec4 weights = vec4((1.0 - between.x) * (1.0 - between.y), between.x * (1.0 - between.y), (1.0 - between.x) * between.y,
                      between.x * between.y);
  float shown = 0.0;
  float total = 0.0;
  int same = 0;
  vec3 point = vec3(0.0);
  vec3 n = vec3(0.0);
  for (int k = 0; k < 4; ++k) {
    if (interiorNumber(bits[k]) != solid) continue;
    shown += weights[k];
    if (dot(direction, s[k].n) <= 0.0 || !exitSame(own.point, own.n, s[k].point, s[k].n)) continue;
    total += weights[k];
    point += weights[k] * s[k].point;
    n += weights[k] * s[k].n;
    hit.alpha += weights[k] * unpackHalf2x16(bits[k].z).x;
    ++same;
  }
  if (!(total > 0.0)) return hit;
  point /= total;
  n = normalize(n);
  float met = exitPlane(origin, direction, point, n);
  vec2 moved = exitAt(ray, met).xy - at;
  // More than a texel away others would have had to be asked: the steps have not settled.
  if (!(met > 0.0 && dot(moved, moved) <= 1.0)) return hit;
  hit.found = shown;
  hit.point = origin + met * direction;
  hit.n = n;
  hit.alpha /= total;
  hit.distance = met;
  if (same == 4)
    hit.curvature = exitCurvature(n, direction, 0.5 * (s[1].point - s[0].point + s[3].point - s[2].point),
                                  0.5 * (s[1].n - s[0].n + s[3].n - s[2].n),
                                  0.5 * (s[2].point - s[0].point + s[3].point - s[1].point),
                                  0.5 * (s[2].n - s[0].n + s[3].n - s[1].n));
  return hit;
}

#endif
