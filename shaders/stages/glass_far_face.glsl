// glass_far_face.glsl: colour and clear share of the face where light leaves a solid, for bodies whose faces differ: labels,
// gradients, bodies of two materials.
// Needs    stages/glass_inside.glsl, stages/surroundings.glsl.
// Source   app/README.md, "Bodies of glass".
// Limits   the texel nearest to the point; a face that no layer holds has the near one's values.

struct FarFace {
    vec3 tint;   // of what crosses it: the root of the base colour
    float clear; // share that light crosses
};

// `near`: the face that light comes in by.
FarFace farFaceAt(vec3 point, FarFace near) {
    if (!facesDiffer) return near;
    FarFace face = near;
    vec4 clip = frame.clipFromWorld * vec4(point, 1.0);
    ivec2 at = ivec2(floor(pixelOf(clip)));
    ivec2 size = ivec2(frame.picture.xy);
    bool shown = clip.w > 0.0 && all(greaterThanEqual(at, ivec2(0))) && all(lessThan(at, size));
    if (!shown) return face;
    // Of the body's faces there the one nearest to the point.
    float least = 2.0;
    for (int layer = 0; layer < 2 * interiorPairs; ++layer) {
        uvec4 bits = texelFetch(interior, ivec3(at, layer), 0);
        float apart = abs(uintBitsToFloat(bits.x) - clip.z / clip.w);
        if (interiorNumber(bits) != float(objectId()) || apart >= least) continue;
        least = apart;
        face.tint = interiorTint(bits);
        face.clear = interiorClear(bits);
    }
    return face;
}
