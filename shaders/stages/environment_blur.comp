// environment_blur.comp: one Gaussian step on the lattice of a cube level.
// Weights that keep constants and the mean come from the host (app/environment/face_balance.h).
#version 450
#include "environment/heat_kernel.glsl"
#include "interface/environment_step.glsl"
#include "stages/environment_weigh.glsl"
#include "stages/half_float.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

layout(binding = 1) uniform sampler2DArray weighted; // of the step before (environment_weigh.glsl)
layout(binding = 3, rgba16f) uniform writeonly imageCube result;

vec4 kernelOf(vec4 chord2, vec4 inverse) {
    return vec4(heatKernel(chord2.x, inverse.x), heatKernel(chord2.y, inverse.y), heatKernel(chord2.z, inverse.z),
                heatKernel(chord2.w, inverse.w));
}

void main() {
    ivec3 id = ivec3(gl_GlobalInvocationID);
    ivec2 at = 2 * id.xy;
    int size = environmentStep.sizes.x;
    if (at.x >= size || at.y >= size) return;
    Quad own = quad(id.z, at, size);

    // What halving has added varies over a face, by the area that it averaged: z³ relative to that of the texel at the
    // face's centre. Half of it by each end keeps the kernel symmetric, and 1 - a - b is taken for (1 - a)(1 - b), as both
    // are below 0.03.
    vec4 ownZ = quadLocal(id.z, own).z;
    vec4 inverse = environmentStep.kernel.z / (1.0 - environmentStep.kernel.w * ownZ * ownZ * ownZ);
    float limit = environmentStep.kernel.y;
    // What any of the four may reach; of its sine an upper and of its cosine a lower bound.
    float cap = environmentStep.kernel.x + own.spread;
    float cosCap = 1.0 - 0.5 * cap * cap;

    vec4 red = vec4(0.0);
    vec4 green = vec4(0.0);
    vec4 blue = vec4(0.0);
    vec4 total = vec4(0.0);
    for (int face = 0; face < 6; face++) {
        Quad local = quadLocal(face, own);
        CubeRange range = cubeCapFace(local.centre, cosCap, cap, size);
        for (int y = range.firstY; y <= range.lastY; y++) {
            float t = cubeCoordinate(y, size);
            ivec2 part = cubeCapRow(local.centre, cosCap, t, size);
            int last = min(part.y, range.lastX);
            for (int x = max(part.x, range.firstX); x <= last; x++) {
                float s = cubeCoordinate(x, size);
                float z = inversesqrt(1.0 + s * s + t * t);
                vec4 chord2 = quadChord2(local, vec3(s * z, t * z, z));
                float added = environmentStep.kernel.w * z * z * z;
                vec4 kernel = kernelOf(chord2, inverse * (1.0 + added + added * added));
                kernel = mix(kernel, vec4(0.0), greaterThan(chord2, vec4(limit)));
                vec4 texel = texelFetch(weighted, ivec3(x, y, face), 0);
                red += kernel * texel.x;
                green += kernel * texel.y;
                blue += kernel * texel.z;
                total += kernel * texel.w;
            }
        }
    }
    red = roundToHalfFour(red / total);
    green = roundToHalfFour(green / total);
    blue = roundToHalfFour(blue / total);
    for (int k = 0; k < 4; k++) imageStore(result, ivec3(quadTexel(at, k), id.z), vec4(red[k], green[k], blue[k], 1.0));
    weighQuad(ivec3(at, id.z), size, environmentStep.sizes.y, red, green, blue);
}
