// environment_weigh.glsl: the input of the next blur step from a quad of texels: radiance times a texel's weight, and the weight,
// so that the blur reads one texel for each of its own. On the way it may be halved: the quad becomes one texel,
// and an average over solid angle keeps the mean over the sphere exactly.
#include "stages/environment_quad.glsl"

layout(binding = 6, rgba32f) uniform writeonly imageCube weightedResult;
layout(binding = 7) uniform sampler2D nextWeights; // one face of the next level, as all are alike

// `size` texels wide are the faces of the quad's level, `next` those of the next: as many, half as many, or 0 if there is none.
void weighQuad(ivec3 at, int size, int next, vec4 red, vec4 green, vec4 blue) {
    vec4 area;
    for (int k = 0; k < 4; k++) {
        ivec2 texel = quadTexel(at.xy, k);
        area[k] = cubeTexelSolidAngle(texel.x, texel.y, size);
    }
    vec3 mean = vec3(dot(area, red), dot(area, green), dot(area, blue)) / dot(area, vec4(1.0));
    // One loop for both, as what reads and writes textures is most of the code that drivers have to compile.
    bool halved = next < size;
    int count = next == 0 ? 0 : halved ? 1 : 4;
    for (int k = 0; k < count; k++) {
        ivec2 texel = halved ? at.xy / 2 : quadTexel(at.xy, k);
        vec3 radiance = halved ? mean : vec3(red[k], green[k], blue[k]);
        float weight = texelFetch(nextWeights, texel, 0).x;
        imageStore(weightedResult, ivec3(texel, at.z), vec4(weight * radiance, weight));
    }
}
