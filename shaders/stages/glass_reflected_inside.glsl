// glass_reflected_inside.glsl: the fifth pass over a solid of glass: light that leaves it after total internal reflections.
// Writes   radiance, added to what is there; 0 where there were none.
#include "stages/glass_material.glsl"
#include "stages/glass_arrival.glsl"
#include "stages/glass_lobes.glsl"

layout(location = 0) out vec4 outColor;

void writeReflectedInside(bool shown) {
    Surface s = readSurface(surfaceBaseColor());
    float ior = glassIor();
    InnerPath path;
    path.last = readLastArrival(1.0 / ior);
    path.reflectedInside = shown && path.last.run > 0.0 && endWithinGlass() < 0.0;
    WeightedLobe w = seenThrough(reflectedInsideLobe(path), transmissionTint(s));
    outColor = vec4(0.0);
    GlassLookup g = lookupOf(w);
    g.transmitted = true;
    if (path.reflectedInside) outColor = vec4(lookupRadiance(g), 0.0);
}
