#version 450
// Includes a file twice, directly and through another.
#include "shared.glsl"
#include "uses_shared.glsl"
#include "shared.glsl"
layout(local_size_x = 8, local_size_y = 4, local_size_z = 2) in;
layout(std430, binding = 2) buffer Numbers { float numbers[]; };

void main() {
    numbers[0] = usesShared();
}
