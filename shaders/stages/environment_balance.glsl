// environment_balance.glsl: where the weights of a lattice's texels are kept.
// A face is its own mirror image both ways: a quarter of it is balanced, and kept four times.
layout(binding = 4) uniform sampler2D weights; // one face, as all are alike: area times the balance so far
layout(binding = 5, r32f) uniform writeonly image2D weightsResult;

void keepWeight(ivec2 at, int size, float weight) {
    ivec2 mirrored = ivec2(size - 1) - at;
    imageStore(weightsResult, at, vec4(weight));
    imageStore(weightsResult, ivec2(mirrored.x, at.y), vec4(weight));
    imageStore(weightsResult, ivec2(at.x, mirrored.y), vec4(weight));
    imageStore(weightsResult, mirrored, vec4(weight));
}
