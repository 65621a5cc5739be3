// The octahedral map of the environment: a square tile of `size` texels with a border of one on each side.
vec2 ggMirrored(vec2 p) {
  if (abs(p.x) > 1.0) p = vec2(sign(p.x) * 2.0 - p.x, -p.y);
  if (abs(p.y) > 1.0) p = vec2(-p.x, sign(p.y) * 2.0 - p.y);
  return p;
}
vec3 ggDecoded(vec2 p) {
  float y = 1.0 - abs(p.x) - abs(p.y);
  vec2 fold = max(-y, 0.0) * vec2(p.x < 0.0 ? -1.0 : 1.0, p.y < 0.0 ? -1.0 : 1.0);
  return normalize(vec3(p.x - fold.x, y, p.y - fold.y));
}
vec3 ggHere(vec2 place, float size) { return ggDecoded(ggMirrored(2.0 * (place * (size + 2.0) - 1.0) / size - 1.0)); }
