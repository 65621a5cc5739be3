// environment.glsl: the environment of the frame, by world directions.
// Needs    interface/frame.glsl.
#include "environment/gaussian_stack_fetch.glsl"

layout(binding = 16) uniform samplerCube stackEven;
layout(binding = 17) uniform samplerCube stackOdd;
layout(binding = 18) uniform samplerCube irradianceCube;

vec3 inEnvironment(vec3 direction) {
    return environmentRotate(direction, frame.environment.x, frame.environment.y);
}
