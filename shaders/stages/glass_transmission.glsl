// glass_transmission.glsl: the third pass over a solid of glass: the lobes that leave it by the first face.
// Writes   stages/glass_lobes.glsl.
#include "stages/glass_material.glsl"
#include "stages/glass_arrival.glsl"
#include "stages/glass_lobes.glsl"

layout(location = 0) out vec4 outCoreOrigin;
layout(location = 1) out vec4 outCoreShape;
layout(location = 2) out vec4 outRestOrigin;
layout(location = 3) out vec4 outRestShape;
layout(location = 4) out vec4 outWeight;

void writeTransmission() {
    Surface s = readSurface(surfaceBaseColor());
    float ior = glassIor();
    float entered = faceEnergy(dot(s.n, s.wo), s.alpha, ior).transmitted;
    InnerPath path;
    path.first = readFirstArrival(s, enteringLobe(0, s, ior, entered), entered, 1.0 / ior);
    GlassLobes lobes = composedLobes(s, ior, path);
    if (holdsOpaque) lobes = lobesEndingInside(lobes, s, path.first.ray, entered, endWithinGlass());
    vec3 tint = transmissionTint(s);
    lobes.core.weight *= tint;
    lobes.rest.weight *= tint;
    outCoreOrigin = packedOrigin(lobes.core.lobe);
    outCoreShape = packedShape(lobes.core.lobe);
    outRestOrigin = packedOrigin(lobes.rest.lobe);
    outRestShape = packedShape(lobes.rest.lobe);
    outWeight = packedWeight(lobes.core, lobes.rest);
}
