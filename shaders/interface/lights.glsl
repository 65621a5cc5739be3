// lights.glsl: punctual lights (KHR_lights_punctual). One text for GLSL and C++ (app/uniforms/blocks.h).

struct LightData {
    vec4 position;  // xyz: metres; w: 1 / range², 0 without a range
    vec4 direction; // xyz: unit, the way light travels; w: kind, 0 directional, 1 point, 2 spot
    vec4 intensity; // xyz: lux (directional) or candela
    vec4 cone;      // x: scale, y: offset of the spot's falloff; z: its first shadow view, w: how many, 0: none is drawn, -1: nothing
                    // casts
};

#ifndef __cplusplus
layout(std430, binding = 3) readonly buffer Lights {
    LightData lights[];
};
#endif
