// instance.glsl: where one mesh stands. One text for GLSL and C++ (app/uniforms/blocks.h).

struct InstanceData {
    mat4 worldFromMesh;
    mat4 normalFromMesh; // 3 x 3: inverse transpose, up to a positive factor; [3][0]: the instance's
                         // number; [3][3]: -1 if mirrored, else 1
};

#ifndef __cplusplus
layout(std140, binding = 1) uniform Instance {
    InstanceData instance;
};
#endif
