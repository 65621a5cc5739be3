// packed_maps.glsl: what maps, factors and colours of vertices say of a surface, in 128 bits: halves of colour and emission, 12
// bits of roughness, 10 of metallic and of occlusion. Textures have 8.
// Limits   emission up to 65504.

struct MapValues {
    vec3 base;
    vec2 metal; // metallic, glTF's roughness
    float occlusion;
    vec3 emissive;
};

const float MOST_HALF = 65504.0;

uint packedShare(float share, float most) { return uint(clamp(share, 0.0, 1.0) * most + 0.5); }

uvec4 packedMaps(vec3 base, vec2 metal, float occlusion, vec3 emissive) {
    vec3 light = min(emissive, vec3(MOST_HALF));
    vec3 color = min(base, vec3(MOST_HALF));
    uint shares = packedShare(metal.y, 4095.0) | packedShare(metal.x, 1023.0) << 12u | packedShare(occlusion, 1023.0) << 22u;
    return uvec4(packHalf2x16(color.xy), packHalf2x16(vec2(color.z, light.x)), packHalf2x16(light.yz), shares);
}

MapValues unpackedMaps(uvec4 bits) {
    vec2 middle = unpackHalf2x16(bits.y);
    MapValues m;
    m.base = vec3(unpackHalf2x16(bits.x), middle.x);
    m.emissive = vec3(middle.y, unpackHalf2x16(bits.z));
    m.metal = vec2(float(bits.w >> 12u & 1023u) / 1023.0, float(bits.w & 4095u) / 4095.0);
    m.occlusion = float(bits.w >> 22u) / 1023.0;
    return m;
}
