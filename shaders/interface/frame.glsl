// frame.glsl: what every draw of a frame shares. One text for GLSL and C++ (app/uniforms/blocks.h).
// Layout   only vec4, ivec4 and mat4, so that std140 and C++ agree without padding rules.

struct FrameData {
    mat4 clipFromWorld; // with this sample's sub-pixel offset
    mat4 worldFromClip; // its inverse: sky directions
    vec4 eye;           // xyz: the camera's position, metres; w: 1, or 0 for an orthographic camera
    vec4 viewDirection; // xyz: unit, where an orthographic camera looks
    vec4 environment;   // x, y: cosine and sine of its rotation about +Y; z: intensity
    vec4 stack;         // the Gaussian stack's shape (environment/gaussian_stack.glsl)
    vec4 picture;       // x, y: its size in pixels; z: focal length in pixels, pixels per metre if orthographic;
                        // w: last level of the screen pyramid
    vec4 boundsLow;     // xyz: the box that holds the scene, metres
    vec4 boundsHigh;
    vec4 part;          // xyz: of every lobe, the part that this sample of a pixel stands for (refraction/lobe_stratum.glsl);
                        // w: variance per axis of the places in its share of the pixel, pixels²
    ivec4 counts;       // x: punctual lights; y: walls
    vec4 sunDirection;  // xyz: to the sun in the environment; w: half of its angular radius, sigma
    vec4 sunIrradiance; // xyz: across that direction, 0: there is none
    vec4 walls[12];     // of each: its centre, metres; and the two gradients, per metre, of where on it a place is, -1 to 1
    vec4 background;    // w: 0, or sigma of the environment where nothing was drawn, radians; -1: there is radiance xyz instead
};

#ifndef __cplusplus
layout(std140, binding = 0) uniform Frame {
    FrameData frame;
};
#endif
