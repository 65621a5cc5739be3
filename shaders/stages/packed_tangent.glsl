// packed_tangent.glsl: a region's number and the way that the tangent points about the normal, in the 32 bits that the G-buffer has
// left: 20 of the number, 11 of the angle, 1 of the bitangent's sign.
// Frame    world. n: as octDecode() gives it, so that both ends have the same frame about it.
// Limits   the angle is off by 1.5 thousandths of a radian at most.
#include "bsdf/constants.glsl"

const float TANGENT_STEPS = 2048.0;

// Two directions across n [Duff17].
vec3 firstAcross(vec3 n) {
    float s = n.z >= 0.0 ? 1.0 : -1.0;
    float a = -1.0 / (s + n.z);
    return vec3(1.0 + s * n.x * n.x * a, s * n.x * n.y * a, -s * n.x);
}

// From 1 to 2^20 - 1.
uint packedNumber(uint number) { return number << 12u; }

uint unpackedNumber(uint bits) { return bits >> 12u; }

// tangent: as opaque.vert sends it; w's sign about n.
uint packedTangent(vec3 n, vec4 tangent) {
    vec3 x = firstAcross(n);
    vec2 at = vec2(dot(tangent.xyz, x), dot(tangent.xyz, cross(n, x)));
    float turn = dot(at, at) > 0.0 ? fract(atan(at.y, at.x) / (2.0 * BSDF_PI)) : 0.0;
    uint angle = uint(turn * TANGENT_STEPS + 0.5) & 2047u;
    return angle << 1u | (tangent.w < 0.0 ? 1u : 0u);
}

vec4 unpackedTangent(uint bits, vec3 n) {
    vec3 x = firstAcross(n);
    float angle = float(bits >> 1u & 2047u) * (2.0 * BSDF_PI / TANGENT_STEPS);
    return vec4(cos(angle) * x + sin(angle) * cross(n, x), (bits & 1u) != 0u ? -1.0 : 1.0);
}
