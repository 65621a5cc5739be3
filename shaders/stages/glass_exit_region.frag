// glass_exit_region.frag: glass_exit.glsl by region.
#version 450
#include "interface/frame.glsl"
#include "interface/instance.glsl"
#include "interface/lights.glsl"
#include "interface/material.glsl"
#include "stages/material_features.glsl"
#include "stages/region_surface.glsl"
#include "stages/glass_exit.glsl"
#include "stages/region_read.glsl"

void main() {
    if (!readRegion()) discard;
    writeExit();
}
