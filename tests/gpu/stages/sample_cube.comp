#version 450
// Looks up a list of directions.
layout(local_size_x = 1) in;
layout(binding = 0) uniform samplerCube map;
layout(std430, binding = 1) readonly buffer Directions { vec4 directions[]; };
layout(std430, binding = 2) writeonly buffer Colors { vec4 colors[]; };
layout(constant_id = 0) const float level = 0.0;

void main() {
    uint i = gl_WorkGroupID.x;
    colors[i] = textureLod(map, directions[i].xyz, level);
}
