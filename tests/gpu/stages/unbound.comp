#version 450
layout(local_size_x = 1) in;
layout(std430) buffer Numbers { float numbers[]; };
layout(std430) buffer More { float more[]; };

void main() {
    numbers[0] = more[0];
}
