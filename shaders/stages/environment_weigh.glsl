// environment_weigh.glsl: what a quad of texels hands on to the next step of blur: radiance times a texel's weight, and the
// weight beside it, so that the blur reads one texel per tap. On the way it may be halved: the quad becomes one texel,
// and an average over solid angle keeps the mean over the sphere exactly.
#include "stages/environment_quad.glsl"

layout(binding = 6, rgba32f) uniform writeonly imageCube weightedResult;
layout(binding = 7) uniform sampler2D nextWeights; // one face of the next level, as all are alike

// `size` texels wide are the faces of the quad's level, `next` those of the next: as many, half as many, or 0 if there is none.
void weighQuad(ivec3 at, int size, int next, vec4 red, vec4 green, vec4 blue) {
    if (next == size) {
        for (int k = 0; k < 4; k++) {
            ivec2 texel = quadTexel(at.xy, k);
            float weight = texelFetch(nextWeights, texel, 0).x;
            imageStore(weightedResult, ivec3(texel, at.z), vec4(weight * vec3(red[k], green[k], blue[k]), weight));
        }
    } else if (next > 0) {
        vec4 area;
        for (int k = 0; k < 4; k++) {
            ivec2 texel = quadTexel(at.xy, k);
            area[k] = cubeTexelSolidAngle(texel.x, texel.y, size);
        }
        ivec2 texel = at.xy / 2;
        float weight = texelFetch(nextWeights, texel, 0).x;
        vec3 mean = vec3(dot(area, red), dot(area, green), dot(area, blue)) / dot(area, vec4(1.0));
        imageStore(weightedResult, ivec3(texel, at.z), vec4(weight * mean, weight));
    }
}
