// environment_weigh.comp: prepares a cube level for a step of blur: radiance times a texel's weight, and the weight beside it, so
// that the blur reads one texel per tap. On the way it may halve: four texels tile one, and their average over solid
// angle keeps the mean over the sphere exactly.
#version 450
#include "environment/cube.glsl"
#include "interface/environment_step.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

layout(constant_id = 0) const bool halving = true;

layout(binding = 1) uniform sampler2DArray source;
layout(binding = 2) uniform sampler2D weights; // one face: all are alike
layout(binding = 3, rgba32f) uniform writeonly imageCube weighted;

void main() {
    ivec3 texel = ivec3(gl_GlobalInvocationID);
    int size = environmentStep.sizes.x;
    if (texel.x >= size || texel.y >= size) return;
    vec3 radiance = vec3(0.0);
    if (halving) {
        float total = 0.0;
        for (int k = 0; k < 4; k++) {
            ivec2 at = 2 * texel.xy + ivec2(k & 1, k >> 1);
            float area = cubeTexel(at.x, at.y, 2 * size).solidAngle;
            radiance += area * texelFetch(source, ivec3(at, texel.z), 0).xyz;
            total += area;
        }
        radiance /= total;
    } else {
        radiance = texelFetch(source, texel, 0).xyz;
    }
    float weight = texelFetch(weights, texel.xy, 0).x;
    imageStore(weighted, texel, vec4(weight * radiance, weight));
}
