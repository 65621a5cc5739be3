#version 450
layout(local_size_x = 1) in;
layout(std430) buffer Numbers { float numbers[]; };

void main() {
    numbers[0] = 1.0;
}
