#version 450
// As sample_cube.comp, of the second cube of an array.
layout(local_size_x = 1) in;
layout(binding = 0) uniform samplerCubeArray map;
layout(std430, binding = 1) readonly buffer Directions { vec4 directions[]; };
layout(std430, binding = 2) writeonly buffer Colors { vec4 colors[]; };

void main() {
    uint i = gl_WorkGroupID.x;
    colors[i] = textureLod(map, vec4(directions[i].xyz, 1.0), 0.0);
}
