// cube.glsl: the six faces of a cube map as lattices on the sphere.
// Frame    world. Faces 0..5 = +X -X +Y -Y +Z -Z; s to the right and t down a face's image, both in [-1, 1].
// alpha    none. size = texels along a face's edge, >= 1; index (x, y) from the image's first texel.
// Returns  cubeDirection: not normalised, its largest component +-1. cubeTexelDirection: unit. cubeLocal: d in the frame of
//          a face: x along s, y along t, z out of the face. cubeTexelSolidAngle: sr. cubeCapFace: the texels of a face
//          that a cap may touch, none if last < first. cubeTexel: its direction in cubeLocal's frame, and sr.
// Source   OpenGL 4.5 core, table 8.19 (which Vulkan shares).
// Limits   cubeTexelSolidAngle: midpoint rule with its next term, relative error 2e-4 at size 4, 1e-6 at size 16; exact
//          differences of arctangents would cancel in float32. cubeCapFace: radius below a right angle.
#ifndef GG_ENVIRONMENT_CUBE_GLSL
#define GG_ENVIRONMENT_CUBE_GLSL

const float CUBE_QUARTER_PI = 0.78539816339744830962;

vec3 cubeDirection(int face, float s, float t) {
  if (face == 0) return vec3(1.0, -t, -s);
  if (face == 1) return vec3(-1.0, -t, s);
  if (face == 2) return vec3(s, 1.0, t);
  if (face == 3) return vec3(s, -1.0, -t);
  if (face == 4) return vec3(s, -t, 1.0);
  return vec3(-s, -t, -1.0);
}

float cubeCoordinate(int index, int size) { return (2.0 * float(index) + 1.0) / float(size) - 1.0; }

vec3 cubeTexelDirection(int face, int x, int y, int size) {
  return normalize(cubeDirection(face, cubeCoordinate(x, size), cubeCoordinate(y, size)));
}

vec3 cubeLocal(int face, vec3 d) {
  if (face == 0) return vec3(-d.z, -d.y, d.x);
  if (face == 1) return vec3(d.z, -d.y, -d.x);
  if (face == 2) return vec3(d.x, d.z, d.y);
  if (face == 3) return vec3(d.x, -d.z, -d.y);
  if (face == 4) return vec3(d.x, -d.y, d.z);
  return vec3(-d.x, -d.y, -d.z);
}

// A texel in the frame of its own face: unit direction and solid angle. With r² = 1 + s² + t² the angle is h² / r³ at the
// centre, and h²/24 of its Laplacian adds the next order of the integral over the texel, h⁴.
struct CubeTexel {
  vec3 local;
  float solidAngle;
};

CubeTexel cubeTexel(int x, int y, int size) {
  CubeTexel texel;
  texel.local = normalize(vec3(cubeCoordinate(x, size), cubeCoordinate(y, size), 1.0));
  float z2 = texel.local.z * texel.local.z;
  float h2 = 4.0 / float(size * size);
  texel.solidAngle = h2 * texel.local.z * z2 * (1.0 + h2 / 24.0 * (9.0 - 15.0 * z2) * z2);
  return texel;
}

float cubeTexelSolidAngle(int x, int y, int size) { return cubeTexel(x, y, size).solidAngle; }

struct CubeRange {
  int firstX;
  int lastX;
  int firstY;
  int lastY;
};

// First and last index whose texel centre can lie in the cap, along one axis: seen along the other axis, the cap is
// an interval of angles about atan2(along, out), of half-width asin(sinRadius / sqrt(along² + out²)).
ivec2 cubeCapInterval(float along, float outward, float sinRadius, int size) {
  float d = sqrt(along * along + outward * outward);
  float low = -CUBE_QUARTER_PI;
  float high = CUBE_QUARTER_PI;
  if (d > sinRadius) {
    float middle = atan(along, outward);
    float spread = asin(sinRadius / d);
    low = max(low, middle - spread);
    high = min(high, middle + spread);
  }
  if (low > high) return ivec2(1, 0);
  float scale = 0.5 * float(size);
  int first = int(ceil(scale * (tan(low) + 1.0) - 0.5));
  int last = int(floor(scale * (tan(high) + 1.0) - 0.5));
  return ivec2(max(first, 0), min(last, size - 1));
}

// The cap of that angular radius about a unit direction l in the frame of a face, on that face.
CubeRange cubeCapFace(vec3 l, float cosRadius, float sinRadius, int size) {
  CubeRange range;
  range.firstX = 1;
  range.lastX = 0;
  range.firstY = 1;
  range.lastY = 0;
  // A face reaches no further than its corner, whose cosine to the axis is 1/sqrt(3): past the sum of both angles
  // nothing of the cap is on it. cos(a + b) with cos a = 0.57735, sin a = 0.81650.
  if (l.z < 0.57735 * cosRadius - 0.81650 * sinRadius) return range;
  ivec2 rangeX = cubeCapInterval(l.x, l.z, sinRadius, size);
  ivec2 rangeY = cubeCapInterval(l.y, l.z, sinRadius, size);
  range.firstX = rangeX.x;
  range.lastX = rangeX.y;
  range.firstY = rangeY.x;
  range.lastY = rangeY.y;
  return range;
}

#endif
