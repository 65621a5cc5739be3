// environment_weigh.comp: prepares a cube level for a step of blur: radiance times a texel's weight, and the weight beside it, so
// that the blur reads one texel per tap. On the way it may halve: four texels tile one, and their average over solid
// angle keeps the mean over the sphere exactly.
#version 450
#include "environment/cube.glsl"
#include "interface/environment_step.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

layout(binding = 1) uniform sampler2DArray source;
layout(binding = 2) uniform sampler2D weights; // one face: all are alike
layout(binding = 3, rgba32f) uniform writeonly imageCube weighted;

void main() {
    ivec3 texel = ivec3(gl_GlobalInvocationID);
    int size = environmentStep.sizes.x;
    if (texel.x >= size || texel.y >= size) return;
    int perEdge = environmentStep.sizes.y / size; // 2, or 1 where nothing is halved
    vec3 radiance = vec3(0.0);
    float total = 0.0;
    for (int y = 0; y < perEdge; y++) {
        for (int x = 0; x < perEdge; x++) {
            ivec2 at = perEdge * texel.xy + ivec2(x, y);
            float area = cubeTexelSolidAngle(at.x, at.y, environmentStep.sizes.y);
            radiance += area * texelFetch(source, ivec3(at, texel.z), environmentStep.sizes.z).xyz;
            total += area;
        }
    }
    float weight = texelFetch(weights, texel.xy, 0).x;
    imageStore(weighted, texel, vec4(weight / total * radiance, weight));
}
