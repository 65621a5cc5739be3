// glass_footprint_region.frag: glass_footprint.glsl by region.
#version 450
#include "interface/frame.glsl"
#include "interface/instance.glsl"
#include "interface/lights.glsl"
#include "interface/material.glsl"
#include "stages/material_features.glsl"
#include "stages/region_surface.glsl"
#include "stages/glass_footprint.glsl"
#include "stages/region_read.glsl"

void main() {
    bool shown = readRegion();
    writeFootprint();
    if (!shown) discard; // after all derivatives
}
