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
// an interval of angles about that of (along, outward), of half-width asin(sinRadius / sqrt(along² + outward²)). Its ends are
// that vector turned by the half-width, both ways; no angle is needed.
ivec2 cubeCapInterval(float along, float outward, float sinRadius, int size) {
  float low = -1.0;
  float high = 1.0;
  float beside2 = along * along + outward * outward - sinRadius * sinRadius;
  if (beside2 > 0.0) {
    float beside = sqrt(beside2);
    float lowOut = outward * beside + along * sinRadius;
    float highOut = outward * beside - along * sinRadius;
    // An end that is not in front of the face: past it on the end's own side the face is open to there, else it is missed.
    if (lowOut > 0.0) low = max(low, (along * beside - outward * sinRadius) / lowOut);
    else if (along >= 0.0) low = 2.0;
    if (highOut > 0.0) high = min(high, (along * beside + outward * sinRadius) / highOut);
    else if (along <= 0.0) high = -2.0;
  }
  if (low > high) return ivec2(1, 0);
  float scale = 0.5 * float(size);
  int first = int(ceil(scale * (low + 1.0) - 0.5));
  int last = int(floor(scale * (high + 1.0) - 0.5));
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

// First and last index of that cap on one row of the face, at coordinate t, or all of it. Where l.(s, t, 1) = cosRadius
// |(s, t, 1)|, for s; what is under the root is rounded by up to 4e-7, which is added to keep what lies on the rim.
ivec2 cubeCapRow(vec3 l, float cosRadius, float t, int size) {
  float k = l.y * t + l.z;
  float a = cosRadius * cosRadius - l.x * l.x;
  float inside = k * k - a * (1.0 + t * t) + 4e-7;
  if (a <= 0.0) return ivec2(0, size - 1);
  if (inside < 0.0) return ivec2(1, 0);
  float middle = l.x * k;
  float spread = cosRadius * sqrt(inside);
  float scale = 0.5 * float(size);
  int first = int(ceil(scale * ((middle - spread) / a + 1.0) - 0.5));
  int last = int(floor(scale * ((middle + spread) / a + 1.0) - 0.5));
  return ivec2(max(first, 0), min(last, size - 1));
}

#endif
