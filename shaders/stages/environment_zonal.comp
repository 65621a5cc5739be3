// environment_zonal.comp: convolution with any kernel of the angle, over all pairs of texels: the widest Gaussians, where a
// plane is no likeness of the sphere any more, and the cosine of diffuse light.
// Weights keep both constants and the mean after [SinkhornKnopp67]'s balancing, stages 1 and 2 in turn:
//   stage 0   rows(d) = sum over sources of k area(s)
//   stage 1   columns(s) = 1 / sum over results of k area(d) / rows(d)
//   stage 2   rows(d) = sum over sources of k area(s) columns(s)
//   stage 3   the average with weights k area(s) columns(s)
#version 450
#include "environment/cube.glsl"
#include "interface/environment_step.glsl"
#include "stages/half_float.glsl"

layout(local_size_x = 4, local_size_y = 4) in;

layout(constant_id = 0) const int stage = 3;

layout(binding = 1) uniform sampler2DArray source;
layout(binding = 2) uniform sampler2D kernels; // k over half the chord, one row per kernel; linear
layout(binding = 3) uniform sampler2D rows;    // one face of the result
layout(binding = 4) uniform sampler2D columns; // one face of the source
layout(binding = 5, rgba16f) uniform writeonly imageCube result;
layout(binding = 6, r32f) uniform writeonly image2D balanceResult;

void main() {
    ivec3 texel = ivec3(gl_GlobalInvocationID);
    int size = stage == 1 ? environmentStep.sizes.y : environmentStep.sizes.x;  // of the lattice that is walked outside
    int other = stage == 1 ? environmentStep.sizes.x : environmentStep.sizes.y; // and inside
    if (texel.x >= size || texel.y >= size) return;
    vec3 d = cubeTexelDirection(texel.z, texel.x, texel.y, size);
    vec2 tableSize = vec2(textureSize(kernels, 0));
    float row = (environmentStep.kernel.z + 0.5) / tableSize.y;

    vec3 sum = vec3(0.0);
    float total = 0.0;
    // The lattice outside, its texels inside: what depends on the texel alone is the same on all six faces.
    for (int y = 0; y < other; y++) {
        for (int x = 0; x < other; x++) {
            CubeTexel there = cubeTexel(x, y, other);
            float area = there.solidAngle;
            if (stage == 1) area /= texelFetch(rows, ivec2(x, y), 0).x;
            if (stage >= 2) area *= texelFetch(columns, ivec2(x, y), 0).x;
            for (int face = 0; face < 6; face++) {
                vec3 apart = cubeLocal(face, d) - there.local;
                float halfChord = 0.5 * sqrt(dot(apart, apart));
                float u = (halfChord * (tableSize.x - 1.0) + 0.5) / tableSize.x;
                float weight = textureLod(kernels, vec2(u, row), 0.0).x * area;
                if (stage == 3) sum += weight * texelFetch(source, ivec3(x, y, face), 0).xyz;
                total += weight;
            }
        }
    }
    if (stage == 0 || stage == 2) imageStore(balanceResult, texel.xy, vec4(total));
    if (stage == 1) imageStore(balanceResult, texel.xy, vec4(1.0 / total));
    // The cosine's kernel rings below 0 by less than a thousandth of its peak: light does not.
    if (stage == 3) imageStore(result, texel, vec4(roundToHalfRgb(max(sum / total, vec3(0.0))), 1.0));
}
