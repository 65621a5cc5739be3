// geometry.frag: the G-buffer of surfaces without maps.
#version 450
#include "stages/geometry.glsl"

void main() { outTexel = geometryTexel(); }
