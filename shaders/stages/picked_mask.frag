// picked_mask.frag: 1 where what is picked is, whatever hides it.
#version 450

layout(location = 0) out vec4 outMask;

void main() { outMask = vec4(1.0); }
