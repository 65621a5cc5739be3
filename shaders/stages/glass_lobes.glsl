// glass_lobes.glsl: the two lobes that leave a solid of glass where its light first comes to a face, as its passes hand them on.
// Layout   per pixel, floats of 32 bits (places are seen from far, directions by what they meet):
//          coreOrigin xyz world, metres; w offset (Beam)
//          coreShape  xy direction (octEncode); z sigma; w carried, radians
//          restOrigin, restShape: the other lobe, the same
//          lobeWeight rgb of both together; w the share of the second
// Needs    stages/glass_beams.glsl, refraction/exit_surface.glsl.

layout(binding = 39) uniform sampler2D endWithin; // stages/glass_within.glsl

float endWithinGlass() { return holdsOpaque ? texelFetch(endWithin, ivec2(gl_FragCoord.xy), 0).x : -1.0; }

vec4 packedOrigin(Beam beam) { return vec4(beam.origin, beam.inside * beam.inner); }

vec4 packedShape(Beam beam) { return vec4(octEncode(beam.direction), beam.sigma, beam.carried); }

vec4 packedWeight(WeightedBeam core, WeightedBeam rest) {
    vec3 both = core.weight + rest.weight;
    return vec4(both, largest(rest.weight) / max(largest(both), 1e-30));
}

// Offsets go with what the beam ran inside: as if it had been a metre.
Beam unpackedBeam(vec4 origin, vec4 shape) {
    Beam beam = straightBeam(origin.xyz, octDecode(shape.xy), shape.z);
    beam.inner = origin.w;
    beam.inside = 1.0;
    beam.carried = shape.w;
    return beam;
}
