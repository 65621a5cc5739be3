// environment_zonal.comp: convolution with any kernel of the angle, over all pairs of texels: the widest Gaussians, for
// which the sphere is not flat enough, and the cosine of diffuse light.
// Weights that keep constants and the mean come from the host (app/environment/face_balance.h).
#version 450
#include "interface/environment_step.glsl"
#include "stages/environment_quad.glsl"
#include "stages/half_float.glsl"

layout(local_size_x = 4, local_size_y = 4) in;

layout(binding = 1) uniform sampler2DArray source;
layout(binding = 2) uniform sampler2D kernels; // k over half the chord, one row per kernel
layout(binding = 3, rgba16f) uniform writeonly imageCube result;
layout(binding = 4) uniform sampler2D weights; // of the source, one face as all are alike

vec4 kernelOf(vec4 chord2, int row) {
    int last = textureSize(kernels, 0).x - 1;
    ivec4 place = min(ivec4(0.5 * sqrt(chord2) * float(last) + 0.5), ivec4(last));
    return vec4(texelFetch(kernels, ivec2(place.x, row), 0).x, texelFetch(kernels, ivec2(place.y, row), 0).x,
                texelFetch(kernels, ivec2(place.z, row), 0).x, texelFetch(kernels, ivec2(place.w, row), 0).x);
}

void main() {
    ivec3 id = ivec3(gl_GlobalInvocationID);
    ivec2 at = 2 * id.xy;
    int size = environmentStep.sizes.x;
    int other = environmentStep.sizes.y;
    if (at.x >= size || at.y >= size) return;
    Quad own = quad(id.z, at, size);
    int row = environmentStep.sizes.z;

    vec4 red = vec4(0.0);
    vec4 green = vec4(0.0);
    vec4 blue = vec4(0.0);
    vec4 total = vec4(0.0);
    for (int face = 0; face < 6; face++) {
        Quad local = quadLocal(face, own);
        for (int y = 0; y < other; y++) {
            float t = cubeCoordinate(y, other);
            for (int x = 0; x < other; x++) {
                float s = cubeCoordinate(x, other);
                float z = inversesqrt(1.0 + s * s + t * t);
                vec4 weight = kernelOf(quadChord2(local, vec3(s * z, t * z, z)), row) * texelFetch(weights, ivec2(x, y), 0).x;
                total += weight;
                vec4 texel = texelFetch(source, ivec3(x, y, face), 0);
                red += weight * texel.x;
                green += weight * texel.y;
                blue += weight * texel.z;
            }
        }
    }
    for (int k = 0; k < 4; k++) {
        ivec2 texel = quadTexel(at, k);
        // The cosine's kernel rings below 0 by less than a thousandth of its peak: light does not.
        vec3 mean = max(vec3(red[k], green[k], blue[k]) / total[k], vec3(0.0));
        imageStore(result, ivec3(texel, id.z), vec4(roundToHalfRgb(mean), 1.0));
    }
}
