// environment_step.glsl: what one step of building the Gaussian stack is told. One text for GLSL and C++.

struct EnvironmentStep {
    ivec4 sizes;  // texels along an edge of the result's faces, and of the next step's result (0: none) or, zonal, of the
                  // source's; z, w: width and height of the equirect picture, or, zonal, the kernel's row in the table
    vec4 kernel;  // x: the angle past which nothing is read, y: its squared chord, z: 1 / (2 variance), w: what halving has
                  // added at each end, relative to the variance, at a face's centre (blur)
};

#ifndef __cplusplus
layout(std140, binding = 0) uniform Step {
    EnvironmentStep environmentStep;
};
#endif
