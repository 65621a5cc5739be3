// glass_residual.glsl: the last pass over a solid of glass: the energy that is reflected at the last face that was found.
// Writes   radiance, added to what is there.
#include "stages/glass_material.glsl"
#include "stages/glass_arrival.glsl"
#include "stages/glass_lobes.glsl"

layout(binding = 38) uniform sampler2D lobeWeight; // stages/glass_lobes.glsl

layout(location = 0) out vec4 outColor;

void writeResidual(bool shown) {
    Surface s = readSurface(surfaceBaseColor());
    float ior = glassIor();
    WeightedLobe residual = residualLobe(s, ior, readPath(s, ior));
    residual.weight *= transmissionTint(s);
    if (endWithinGlass() >= 0.0) residual.weight = vec3(0.0);
    vec3 radiance = vec3(0.0);
    // What comes from behind the viewer no picture shows.
    if (losesItsWay && hasEnvironment) {
        residual.weight *= 0.5;
        radiance += residual.weight * wideRadiance(-residual.lobe.direction);
    }
    float share = looked(residual.weight, residual.weight + texelFetch(lobeWeight, ivec2(gl_FragCoord.xy), 0).xyz);
    if (share > 0.0) radiance += share * lookupRadiance(lookupOf(residual));
    // Where it always scatters diffusely, the widest lookup does.
    if (share < 1.0)
        radiance += (1.0 - share) * (interiorPairs < 2 ? farLobe(residual)
                                                       : residual.weight * wideRadiance(residual.lobe.direction));
    outColor = shown ? vec4(radiance, 0.0) : vec4(0.0);
}
