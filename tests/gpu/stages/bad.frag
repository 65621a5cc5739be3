#version 450
#include "wrong.glsl"
layout(location = 0) out vec4 outColor;

void main() {
    outColor = vec4(wrong());
}
