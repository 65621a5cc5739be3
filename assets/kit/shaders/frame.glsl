// What every pass shares: the camera, the tables and the pictures that rough refraction reads.
GG_BLOCK(0) GgFrame {
  mat4 ggClipFromWorld; // y up; w: metres along the camera's axis
  vec4 ggEye;           // and the environment's intensity
  vec4 ggRight;         // half the picture's width and height as directions, and where its middle is seen
  vec4 ggUp;
  vec4 ggForward;
  vec4 ggPicture; // width, height, pixels per unit of tangent, last level of the pyramid
  vec4 ggRange;   // near, far, reach (metres beyond which there is nothing), 1: row 0 of a picture is its lowest
  vec4 ggAtlas;   // texels of the environment's atlases: width, height of the even levels', of the odd ones'; share of a pixel's area that the
                  // picture's sample stands for: 1, or 1 / N where N pictures are averaged
  vec4 ggTiles[LEVELS]; // of the environment's levels: texels along an edge, first row, sigma
};
GG_SAMPLER(4) sampler3D ggEnergy;
GG_SAMPLER(5) sampler3D ggLobes;
GG_SAMPLER(6) sampler3D ggReflection;
GG_SAMPLER(7) sampler2D ggPyramid;
GG_SAMPLER(8) sampler2D ggDepth;
GG_SAMPLER(9) sampler2D ggEnvironmentEven;
GG_SAMPLER(10) sampler2D ggEnvironmentOdd;

// Octahedral tiles, each with a border of one texel.
vec3 ggTile(sampler2D atlas, float height, vec4 tile, vec2 p) {
  vec2 texel = vec2(1.0, tile.y + 1.0) + (0.5 + 0.5 * p) * tile.x;
  return textureLod(atlas, texel / vec2(ggAtlas.x, height), 0.0).rgb;
}
// Levels are sqrt(2) apart in sigma from the first blurred one on; between two the mix keeps the variance. One of two neighbours is even,
// the other odd: one read of each atlas, and of one alone where it is sharp.
vec3 ggEnvironment(vec3 direction, float sigma) {
  vec3 d = direction / (abs(direction.x) + abs(direction.y) + abs(direction.z));
  vec2 p = d.y >= 0.0 ? d.xz : (1.0 - abs(d.zx)) * vec2(d.x < 0.0 ? -1.0 : 1.0, d.z < 0.0 ? -1.0 : 1.0);
  int below = clamp(int(floor(1.0 + 2.0 * log2(max(sigma, 1e-6) / ggTiles[1].z))), 0, LEVELS - 2);
  float low = ggTiles[below].z * ggTiles[below].z;
  float high = ggTiles[below + 1].z * ggTiles[below + 1].z;
  float share = clamp((sigma * sigma - low) / (high - low), 0.0, 1.0);
  int even = below + below % 2;
  int odd = below + 1 - below % 2;
  float oddShare = even == below ? share : 1.0 - share;
  vec3 seen = vec3(0.0);
  if (oddShare < 1.0) seen += (1.0 - oddShare) * ggTile(ggEnvironmentEven, ggAtlas.y, ggTiles[even], p);
  if (oddShare > 0.0) seen += oddShare * ggTile(ggEnvironmentOdd, ggAtlas.z, ggTiles[odd], p);
  return ggEye.w * seen;
}
// Pixels, (0.5, 0.5) the middle of the top left one -> texture coordinates.
vec2 ggPlace(vec2 at) { return vec2(at.x, ggRange.w > 0.5 ? ggPicture.y - at.y : at.y) / ggPicture.xy; }
