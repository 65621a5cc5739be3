// glass_look_region.frag: the radiance of the lobes that leave a solid of glass, over what was drawn.
#version 450
#include "interface/frame.glsl"
#include "interface/instance.glsl"
#include "interface/lights.glsl"
#include "interface/material.glsl"
#include "stages/material_features.glsl"
#include "stages/region_surface.glsl"
#include "stages/glass_material.glsl"
#include "stages/glass_look.glsl"
#include "stages/region_read.glsl"

layout(location = 0) out vec4 outColor;

void main() {
    bool shown = readRegion();
    LobePair pair = readLobes();
    GlassLookup g = lookupOf(pair.core);
    g.rest = pair.rest;
    g.both = entryLobes > 1;
    g.within = endWithinGlass();
    g.transmitted = true;
    vec3 radiance = lookupRadiance(g);
    outColor = shown ? vec4(radiance, 1.0) : vec4(0.0);
}
