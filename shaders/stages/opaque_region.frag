// opaque_region.frag: deferred shading of an opaque surface.
#version 450
#include "interface/region.glsl"
#include "stages/opaque_region.glsl"

layout(location = 0) out vec4 outColor;

void main() { outColor = vec4(opaqueRadiance(regionSurface()), 1.0); }
