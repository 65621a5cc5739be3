// exit_surface.glsl: what a texel of an interior layer says: where a glass surface is and how it stands.
// Frame    world, metres; n out of the solid, on front and back faces alike. Picture: x right, y down, texels from the upper
//          left corner; depth reversed as drawn, 1 at the near plane, 0 at the far plane, so a plane in the world is a plane here.
// alpha    none.
// Returns  octEncode, octDecode: a unit vector as two numbers in [-1, 1] and back; in 2 x 16 bits within .00007 rad.
//          interiorView: the camera as the search uses it. Matrices as in interface/frame.glsl; size in texels.
//          interiorWorld: the point of the world at a place of the picture and a depth. interiorTexelDepth: what one texel's width
//          towards the viewer is in depth. interiorTexelWidth: a texel in metres, at a homogeneous w of clip space.
// Source   [Cigolle14] for the octahedron; the rest is projective geometry.
// Limits   square pixels. The camera must not be sheared.
#ifndef GG_REFRACTION_EXIT_SURFACE_GLSL
#define GG_REFRACTION_EXIT_SURFACE_GLSL

struct InteriorView {
  mat4 clipFromWorld;
  mat4 worldFromClip;
  vec2 size;
  float texelWidth; // metres at w = 1
  vec2 texelDepth;  // x + y depth
};

float signNotZero(float x) { return x < 0.0 ? -1.0 : 1.0; }

vec2 octEncode(vec3 n) {
  float s = 1.0 / (abs(n.x) + abs(n.y) + abs(n.z));
  vec2 p = vec2(n.x * s, n.y * s);
  if (n.z >= 0.0) return p;
  return vec2((1.0 - abs(p.y)) * signNotZero(p.x), (1.0 - abs(p.x)) * signNotZero(p.y));
}

vec3 octDecode(vec2 p) {
  float z = 1.0 - abs(p.x) - abs(p.y);
  float fold = max(-z, 0.0);
  return normalize(vec3(p.x - fold * signNotZero(p.x), p.y - fold * signNotZero(p.y), z));
}

InteriorView interiorView(mat4 clipFromWorld, mat4 worldFromClip, vec2 size) {
  InteriorView view;
  view.clipFromWorld = clipFromWorld;
  view.worldFromClip = worldFromClip;
  view.size = size;
  vec3 right = vec3(clipFromWorld[0][0], clipFromWorld[1][0], clipFromWorld[2][0]);
  vec3 depth = vec3(clipFromWorld[0][2], clipFromWorld[1][2], clipFromWorld[2][2]);
  vec3 w = vec3(clipFromWorld[0][3], clipFromWorld[1][3], clipFromWorld[2][3]);
  view.texelWidth = 2.0 / (size.x * length(right));
  // A step of e metres away from the viewer changes depth = Z / W by (depth . v - W's share) e / W; e is texelWidth W.
  bool perspective = dot(w, w) > 0.0;
  vec3 v = perspective ? normalize(w) : -normalize(depth);
  view.texelDepth = view.texelWidth * vec2(-dot(depth, v), dot(w, v));
  return view;
}

float interiorTexelDepth(InteriorView view, float depth) { return view.texelDepth.x + view.texelDepth.y * depth; }

float interiorTexelWidth(InteriorView view, float w) { return view.texelWidth * w; }

vec3 interiorWorld(InteriorView view, vec2 at, float depth) {
  vec2 clip = vec2(2.0 * at.x / view.size.x - 1.0, 1.0 - 2.0 * at.y / view.size.y);
  vec4 p = view.worldFromClip * vec4(clip.x, clip.y, depth, 1.0);
  return vec3(p.x, p.y, p.z) / p.w;
}

#endif
