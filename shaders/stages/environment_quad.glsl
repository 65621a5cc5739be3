// environment_quad.glsl: 2 x 2 texels of a cube's face that one invocation computes: they read nearly the same texels of the
// source, so each of those is fetched and turned into a direction once for the four.
// Frame    cubeLocal's of a face, or the world's.
// alpha    none.
// Returns  quad: the texels (x, y), (x + 1, y), (x, y + 1), (x + 1, y + 1) of a face `size` texels wide, their unit
//          directions' components beside each other; spread: of their angles to the centre the largest, or a little more.
//          quadChord2: squared distances to a unit direction. quadTexel: which one the k-th is.
// Limits   quadChord2: each to 3e-7 of its chord, as differences of numbers near 1 are. spread: size >= 4.
#ifndef GG_STAGES_ENVIRONMENT_QUAD_GLSL
#define GG_STAGES_ENVIRONMENT_QUAD_GLSL
#include "environment/cube.glsl"

struct Quad {
    vec4 x;
    vec4 y;
    vec4 z;
    vec3 centre; // unit
    float spread;
};

ivec2 quadTexel(ivec2 at, int k) { return at + ivec2(k & 1, k >> 1); }

vec4 quadChord2(Quad q, vec3 d) {
    vec4 x = q.x - d.x;
    vec4 y = q.y - d.y;
    vec4 z = q.z - d.z;
    return x * x + y * y + z * z;
}

Quad quad(int face, ivec2 at, int size) {
    Quad q;
    for (int k = 0; k < 4; k++) {
        ivec2 texel = quadTexel(at, k);
        vec3 d = cubeTexelDirection(face, texel.x, texel.y, size);
        q.x[k] = d.x;
        q.y[k] = d.y;
        q.z[k] = d.z;
    }
    q.centre = normalize(cubeDirection(face, float(2 * at.x + 2) / float(size) - 1.0, float(2 * at.y + 2) / float(size) - 1.0));
    // The chord, and 1 % more: an angle exceeds its chord by a 24th of its square, and half a quad of the smallest face
    // spans 0.36.
    vec4 chord2 = quadChord2(q, q.centre);
    q.spread = 1.01 * sqrt(max(max(chord2.x, chord2.y), max(chord2.z, chord2.w)));
    return q;
}

// The same in the frame of a face: cubeLocal, four times.
Quad quadLocal(int face, Quad q) {
    Quad l = q;
    for (int k = 0; k < 4; k++) {
        vec3 d = cubeLocal(face, vec3(q.x[k], q.y[k], q.z[k]));
        l.x[k] = d.x;
        l.y[k] = d.y;
        l.z[k] = d.z;
    }
    l.centre = cubeLocal(face, q.centre);
    return l;
}

#endif
