// glass_within.glsl: for solids that contain opaque bodies: where those end the light that entered.
// Writes   x metres from where it entered; negative where nothing ends it.
#include "stages/glass_material.glsl"
#include "stages/glass_arrival.glsl"

layout(location = 0) out vec4 outWithin;

void writeWithin() {
    Surface s = readSurface(surfaceBaseColor());
    float ior = glassIor();
    float entered = faceEnergy(dot(s.n, s.wo), s.alpha, ior).transmitted;
    InnerLobe core = enteringLobe(0, s, ior, entered);
    outWithin = vec4(endsInside(s, core, distance(texelFetch(firstPoint, ivec2(gl_FragCoord.xy), 0).xyz, s.position)));
}
