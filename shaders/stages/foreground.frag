// foreground.frag: cuts a thing that stands in front of a layer of glass out of what is seen through it.
#version 450

layout(location = 0) out vec4 outColor;

void main() { outColor = vec4(0.0); }
