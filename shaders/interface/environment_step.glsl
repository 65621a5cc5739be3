// environment_step.glsl: what one step of building the Gaussian stack is told. One text for GLSL and C++.

struct EnvironmentStep {
    ivec4 sizes;  // texels along an edge of the result's and of the source's faces; width and height of the equirect picture
    vec4 kernel;  // x: sigma (equirect) or variance (blur), y: share of a texel's area that halving added to the
                  // variance, z: the kernel's row in the table
};

#ifndef __cplusplus
layout(std140, binding = 0) uniform Step {
    EnvironmentStep environmentStep;
};
#endif
