// layer.glsl: what the draws of one layer of glass share. One text for GLSL and C++ (app/frame/blocks.h).

struct LayerData {
    vec4 backdrop; // x: device depth of the layer's nearest point (1 near, 0 far): what is nearer is in front of it and not
                   // behind; y: last level of the pyramid
};

#ifndef __cplusplus
layout(std140, binding = 4) uniform Layer {
    LayerData layer;
};
#endif
