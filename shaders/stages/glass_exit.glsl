// glass_exit.glsl: the first pass over a solid of glass: where the light that enters first comes to a face from inside.
// Writes   stages/glass_arrival.glsl: point, face.
#include "stages/glass_material.glsl"
#include "stages/glass_arrival.glsl"

layout(location = 0) out vec4 outPoint;
layout(location = 1) out vec4 outFace;

void writeExit() {
    Surface s = readSurface(surfaceBaseColor());
    float ior = glassIor();
    float entered = faceEnergy(dot(s.n, s.wo), s.alpha, ior).transmitted;
    InnerArrival first = firstArrival(s, enteringLobe(0, s, ior, entered), entered, 1.0 / ior);
    PackedArrival p = packArrival(first, 0.0);
    if (goesOn(first, splitAt(first, 1.0 / ior, widening()))) p.point.w = -1.0 - p.point.w;
    outPoint = p.point;
    outFace = p.face;
}
