// shadows.glsl: the shadow maps of punctual lights. One text for GLSL and C++ (app/uniforms/blocks.h).

struct ShadowViewData {
    mat4 clipFromWorld; // depth reversed: nearer to the light is larger
    mat4 worldFromClip;
    vec4 texel;         // x: width of a texel where w is 1, metres; y: texels along each side of a map; z: 1, or 0 from afar
};

const int MOST_SHADOW_VIEWS = 12;

struct ShadowsData {
    ShadowViewData views[MOST_SHADOW_VIEWS]; // by layer of the maps
};

#ifndef __cplusplus
layout(std140, binding = 6) uniform Shadows {
    ShadowsData shadows;
};
#endif
