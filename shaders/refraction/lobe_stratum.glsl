// lobe_stratum.glsl: a Gaussian lobe as many narrower ones, each about a direction of its own, that stand for it together.
// Frame    any; direction unit. A lobe is that of screen_pyramid.glsl (lobeVariance).
// alpha    none; sigma, inner, carried: radians. part: xy where in the lobe, in its sigmas; z the share of its width that a part
//          keeps, in (0, 1]: 1 - z² is the variance of xy over all parts. (0, 0, 1): the whole lobe.
// Returns  lobeStratum: one part. Directions that are unit, widths >= 0.
// Source   a Gaussian is the convolution of two Gaussians; what is carried is conditioned on the part (linear regression).
// Limits   angles are laid out as lengths in the tangent plane: for sigma .5 parts stand a little denser than on the sphere
//          (theta in place of sin theta: 4 % one sigma off the middle).
#ifndef GG_REFRACTION_LOBE_STRATUM_GLSL
#define GG_REFRACTION_LOBE_STRATUM_GLSL

struct LobeStratum {
  vec3 direction;
  vec3 aside; // of the origin, metres per metre that the lobe ran inside
  float sigma;
  float inner;
  float carried;
};

// Across the direction, level in a world whose y is up. Straight up or down any will do.
vec3 lobeSide(vec3 direction) {
  vec3 level = vec3(direction.z, 0.0, -direction.x);
  float s = dot(level, level);
  return s > 0.0 ? level * inversesqrt(s) : vec3(1.0, 0.0, 0.0);
}

LobeStratum lobeStratum(vec3 direction, float sigma, float inner, float carried, vec3 part) {
  vec3 side = lobeSide(direction);
  vec3 off = part.x * side + part.y * cross(direction, side);
  float turn = sigma * length(off);
  LobeStratum p;
  p.direction = cos(turn) * direction + (turn > 0.0 ? sin(turn) / turn : 1.0) * sigma * off;
  p.sigma = part.z * sigma;
  // Offset and angle of a lobe are correlated by carried / sigma: a part's offset goes with its angle as far as they are.
  float together = sigma > 0.0 ? clamp(carried / sigma, -1.0, 1.0) : 0.0;
  p.aside = together * inner * off;
  float rest = sqrt(max(1.0 - together * together * (1.0 - part.z * part.z), 0.0));
  p.inner = rest * inner;
  p.carried = rest > 0.0 ? together * sigma * part.z * part.z / rest : 0.0;
  return p;
}

#endif
