#version 450
layout(local_size_x = 64) in;

struct Row {
    vec4 a;
    uvec2 b;
    float c;
};
layout(std140, binding = 0) uniform Settings {
    vec3 scale; // std140: a float may follow in its fourth component
    float offset;
    vec4 table[3];
    uint count;
};
layout(std430, binding = 7) readonly buffer Input { Row rows[]; };
layout(std430, binding = 9) writeonly buffer Output { Row results[]; };

void main() {
    uint i = gl_GlobalInvocationID.x;
    if (i >= count) return;
    Row row = rows[i];
    results[i].a = row.a * vec4(scale, offset) + table[i % 3];
    results[i].b = row.b + uvec2(rows.length(), i);
    results[i].c = row.c * row.c;
}
