// picked_mask.frag: 1 where the picked object is, hidden or not.
#version 450

layout(location = 0) out vec4 outMask;

void main() { outMask = vec4(1.0); }
