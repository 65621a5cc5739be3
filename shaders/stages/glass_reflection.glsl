// glass_reflection.glsl: the sixth pass over a solid of glass: reflection at its outside.
// Writes   radiance, added to what is there.
#include "stages/glass_material.glsl"

layout(binding = 38) uniform sampler2D lobeWeight; // stages/glass_lobes.glsl

layout(location = 0) out vec4 outColor;

void writeReflection(bool shown) {
    Surface s = readSurface(surfaceBaseColor());
    float leaves = coatLeaves(s);
    vec3 transmitted = texelFetch(lobeWeight, ivec2(gl_FragCoord.xy), 0).xyz;
    vec3 radiance = leaves * s.emissive + coatOverGlass(s, transmitted);
    if (hasEnvironment) {
        EnvironmentLight light = environmentLobe(s);
        light.weight *= leaves;
        light.diffuse *= leaves;
        radiance += light.diffuse;
        radiance += mirrorRadiance(mirrorLobes(s, light), transmitted);
    }
    if (hasLights) radiance += leaves * punctualLight(s);
    outColor = shown ? vec4(radiance, 0.0) : vec4(0.0);
}
