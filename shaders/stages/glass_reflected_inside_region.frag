// glass_reflected_inside_region.frag: glass_reflected_inside.glsl by region.
#version 450
#include "interface/frame.glsl"
#include "interface/instance.glsl"
#include "interface/lights.glsl"
#include "interface/material.glsl"
#include "stages/material_features.glsl"
#include "stages/region_surface.glsl"
#include "stages/glass_reflected_inside.glsl"
#include "stages/region_read.glsl"

void main() {
    writeReflectedInside(readRegion());
}
