// neighbour_light.glsl: what neighbours add to the light that arrives from the environment alone. Over most of a surface that is
// smooth: it is computed at the corners of cells of CELL_STEP pixels per side (neighbour_light.frag), and interpolated in cells
// where it bends little (neighbour_cells.frag).
// Source   [Ward88]: irradiance at few places, interpolated.
// Needs    interface/frame.glsl.
#include "interface/region.glsl"
#include "stages/picture_pixel.glsl"

layout(binding = 51) uniform sampler2D neighbourIrradiance;
layout(binding = 52) uniform sampler2D neighbourReflected;

// Corner (i, j) is the pixel CELL_STEP (i, j).
vec2 cornerPlace(sampler2D corners) {
    return (vec2(picturePixel()) / float(CELL_STEP) + 0.5) / vec2(textureSize(corners, 0));
}

vec3 interpolatedIrradiance() { return textureLod(neighbourIrradiance, cornerPlace(neighbourIrradiance), 0.0).xyz; }
vec3 interpolatedReflected() { return textureLod(neighbourReflected, cornerPlace(neighbourReflected), 0.0).xyz; }
