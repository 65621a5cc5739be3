// environment_blur.comp: one Gaussian step on the lattice of a cube level.
// A row of weights that adds up to 1 keeps constants; to keep the mean, what a texel gives must add up to 1 as well, which
// a lattice with edges does not grant (0.3 % at a face's edge, step after step). The kernel being symmetric, one factor b
// per texel mends both: b(d) sum of k(d, s) b(s) area(s) = 1 [Knight08, symmetric balancing]. Three steps of
// b = sqrt(b / sum) starting from 1 find it; a texel's weight is then area times b.
#version 450
#include "environment/cube.glsl"
#include "environment/heat_kernel.glsl"
#include "interface/environment_step.glsl"
#include "stages/half_float.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

layout(constant_id = 0) const int stage = 0;        // 0 blur, 1 first balance, 2 next balance
layout(constant_id = 1) const bool narrow = false;  // a kernel so small that the sphere is flat within its reach

layout(binding = 1) uniform sampler2DArray weighted; // of environment_weigh.comp
layout(binding = 2) uniform sampler2D weights;       // one face, as all are alike: area times b
layout(binding = 3, rgba16f) uniform writeonly imageCube result;
layout(binding = 4, r32f) uniform writeonly image2D weightsResult;

void main() {
    ivec3 texel = ivec3(gl_GlobalInvocationID);
    int size = environmentStep.sizes.x;
    // A face is its own mirror image both ways: a quarter of it is balanced, and kept four times.
    int side = stage == 0 ? size : size / 2;
    if (texel.x >= side || texel.y >= side) return;
    vec3 d = cubeTexelDirection(texel.z, texel.x, texel.y, size);
    CubeTexel own = cubeTexel(texel.x, texel.y, size);

    // What halving has added varies over a face, by the area that it averaged: z³ relative to that of the texel at the
    // face's centre. Half of it by each end keeps the kernel symmetric.
    float wide = environmentStep.kernel.x / HEAT_KERNEL_KEPT;
    float halving = environmentStep.kernel.y * 2.0 / float(size * size) / HEAT_KERNEL_KEPT;
    float ownHalving = halving * own.local.z * own.local.z * own.local.z;
    float radius = HEAT_KERNEL_REACH * sqrt(wide);
    float cosRadius = cos(radius);
    float sinRadius = sin(radius);
    float limit = sinRadius * sinRadius;

    vec4 sum = vec4(0.0);
    for (int face = 0; face < 6; face++) {
        vec3 l = cubeLocal(face, d);
        CubeRange range = cubeCapFace(l, cosRadius, sinRadius, size);
        for (int y = range.firstY; y <= range.lastY; y++) {
            float t = cubeCoordinate(y, size);
            float across = l.y - l.z * t;
            for (int x = range.firstX; x <= range.lastX; x++) {
                // sin²θ = |l x q|² with q = (s, t, 1) / r: differences of coordinates, no cosine near 1.
                float s = cubeCoordinate(x, size);
                vec3 turned = vec3(across, l.z * s - l.x, l.x * t - l.y * s);
                float z2 = 1.0 / (1.0 + s * s + t * t);
                float sin2 = dot(turned, turned) * z2;
                float inverse = 0.5 / (wide - ownHalving - halving * z2 * sqrt(z2));
                float kernel = narrow ? heatKernelNarrow(sin2, inverse) : heatKernel(sin2, inverse);
                kernel = sin2 > limit ? 0.0 : kernel;
                if (stage == 0) {
                    sum += kernel * texelFetch(weighted, ivec3(x, y, face), 0);
                } else if (stage == 1) {
                    sum.w += kernel * cubeTexel(x, y, size).solidAngle;
                } else {
                    sum.w += kernel * texelFetch(weights, ivec2(x, y), 0).x;
                }
            }
        }
    }
    if (stage == 0) {
        imageStore(result, texel, vec4(roundToHalfRgb(sum.xyz / sum.w), 1.0));
    } else {
        float b = stage == 1 ? 1.0 : texelFetch(weights, texel.xy, 0).x / own.solidAngle;
        vec4 weight = vec4(own.solidAngle * sqrt(b / sum.w));
        ivec2 mirrored = ivec2(size - 1) - texel.xy;
        imageStore(weightsResult, texel.xy, weight);
        imageStore(weightsResult, ivec2(mirrored.x, texel.y), weight);
        imageStore(weightsResult, ivec2(texel.x, mirrored.y), weight);
        imageStore(weightsResult, mirrored, weight);
    }
}
