#version 450
// Enough work to be measured.
layout(local_size_x = 64) in;
layout(std430, binding = 0) buffer Numbers { uint numbers[]; };

void main() {
    uint x = gl_GlobalInvocationID.x;
    for (int i = 0; i < 2000; ++i) x = x * 1664525u + 1013904223u;
    numbers[gl_GlobalInvocationID.x] = x;
}
