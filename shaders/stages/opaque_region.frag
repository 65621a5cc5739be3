// opaque_region.frag: deferred shading of surfaces without maps.
#version 450
#include "stages/opaque_region.glsl"

layout(location = 0) out vec4 outColor;

void main() {
    readGeometry();
    outColor = opaqueColor(surfaceBaseColor());
}
