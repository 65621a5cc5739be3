// environment_halve.comp: a cube level -> one of half the size, by the average over solid angle: four texels tile the one, so
// the mean over the sphere is kept exactly.
#version 450
#include "environment/cube.glsl"
#include "interface/environment_step.glsl"
#include "stages/half_float.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

layout(binding = 1) uniform sampler2DArray source;
layout(binding = 3, rgba16f) uniform writeonly imageCube result;

void main() {
    ivec3 texel = ivec3(gl_GlobalInvocationID);
    int size = environmentStep.sizes.x;
    if (texel.x >= size || texel.y >= size) return;
    vec3 sum = vec3(0.0);
    float total = 0.0;
    for (int k = 0; k < 4; k++) {
        ivec2 at = 2 * texel.xy + ivec2(k & 1, k >> 1);
        float weight = cubeTexelSolidAngle(at.x, at.y, 2 * size);
        sum += weight * texelFetch(source, ivec3(at, texel.z), 0).xyz;
        total += weight;
    }
    imageStore(result, texel, vec4(roundToHalfRgb(sum / total), 1.0));
}
