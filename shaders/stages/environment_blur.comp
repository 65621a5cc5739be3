// environment_blur.comp: one Gaussian step on the lattice of a cube level.
// A row of weights that adds up to 1 keeps constants; to keep the mean, what a texel gives must add up to 1 as well, which
// a lattice with edges does not grant (0.3 % at a face's edge, step after step). The kernel being symmetric, one factor b
// per texel mends both: b(d) sum of k(d, s) b(s) area(s) = 1. `balancing` finds it (b = 1 / sqrt(sum) leaves the square
// of the error) and keeps it beside the lattice, the other pass uses it.
#version 450
#include "environment/cube.glsl"
#include "environment/heat_kernel.glsl"
#include "interface/environment_step.glsl"
#include "stages/half_float.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

layout(constant_id = 0) const bool balancing = false;

layout(binding = 1) uniform sampler2DArray source;
layout(binding = 2) uniform sampler2D lattice; // one face, as all are alike: unit direction in its frame, area times b
layout(binding = 3, rgba16f) uniform writeonly imageCube result;
layout(binding = 4, rgba32f) uniform writeonly image2D latticeResult;

void main() {
    ivec3 texel = ivec3(gl_GlobalInvocationID);
    int size = environmentStep.sizes.x;
    if (texel.x >= size || texel.y >= size) return;
    vec3 d = cubeTexelDirection(texel.z, texel.x, texel.y, size);
    CubeTexel own = cubeTexel(texel.x, texel.y, size);

    // What halving has added varies over a face, by the area that it averaged. Half of it by each end keeps the kernel
    // symmetric; z³ is the area, relative to that of the texel at the face's centre.
    float halving = environmentStep.kernel.y * 2.0 / float(size * size);
    float wide = environmentStep.kernel.x / HEAT_KERNEL_KEPT;
    float narrowed = halving / HEAT_KERNEL_KEPT;
    float ownWidth = wide - narrowed * own.local.z * own.local.z * own.local.z;
    float radius = HEAT_KERNEL_REACH * sqrt(wide);
    float cosRadius = cos(radius);
    float sinRadius = sin(radius);
    float chord2Limit = 2.0 - 2.0 * cosRadius;

    vec3 sum = vec3(0.0);
    float total = 0.0;
    for (int face = 0; face < 6; face++) {
        vec3 l = cubeLocal(face, d);
        CubeRange range = cubeCapFace(l, cosRadius, sinRadius, size);
        for (int y = range.firstY; y <= range.lastY; y++) {
            for (int x = range.firstX; x <= range.lastX; x++) {
                vec4 there;
                if (balancing) {
                    CubeTexel t = cubeTexel(x, y, size);
                    there = vec4(t.local, t.solidAngle);
                } else {
                    there = texelFetch(lattice, ivec2(x, y), 0);
                }
                vec3 apart = l - there.xyz;
                float chord2 = dot(apart, apart);
                float width = ownWidth - narrowed * there.z * there.z * there.z;
                float weight = chord2 > chord2Limit ? 0.0 : heatKernel(chord2, 0.5 / width) * there.w;
                if (!balancing) sum += weight * texelFetch(source, ivec3(x, y, face), 0).xyz;
                total += weight;
            }
        }
    }
    if (balancing) {
        imageStore(latticeResult, texel.xy, vec4(own.local, own.solidAngle * inversesqrt(total)));
    } else {
        imageStore(result, texel, vec4(roundToHalfRgb(sum / total), 1.0));
    }
}
