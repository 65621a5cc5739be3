// glass_reflections.glsl: the second pass over a solid of glass: total internal reflections, from the first face to the last
// that is found.
// Writes   stages/glass_arrival.glsl; nothing where there is no total reflection.
#include "stages/glass_material.glsl"
#include "stages/glass_arrival.glsl"

layout(location = 0) out vec4 outPoint;
layout(location = 1) out vec4 outFace;
layout(location = 2) out vec4 outRay;
layout(location = 3) out vec4 outWay;

void writeReflections() {
    Surface s = readSurface(surfaceBaseColor());
    float ior = glassIor();
    float entered = faceEnergy(dot(s.n, s.wo), s.alpha, ior).transmitted;
    InnerArrival first = readFirstArrival(s, enteringLobe(0, s, ior, entered), entered, 1.0 / ior);
    InnerPath path = followFaces(s, first, true, 1.0 / ior, widening());
    if (!path.reflectedInside) discard;
    PackedArrival p = packArrival(path.last, path.passedBetween);
    outPoint = p.point;
    outFace = p.face;
    outRay = p.ray;
    outWay = p.way;
}
