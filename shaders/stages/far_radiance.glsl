// far_radiance.glsl: radiance of the environment, 0 where there is none.
// Needs    stages/environment.glsl, stages/material_features.glsl.

vec3 farRadiance(vec3 direction, float sigma) {
    if (!hasEnvironment) return vec3(0.0);
    return frame.environment.z * environmentRadiance(stackEven, stackOdd, frame.stack, inEnvironment(direction), sigma);
}

// The cosine-weighted mean about a direction.
vec3 wideRadiance(vec3 direction) {
    if (!hasEnvironment) return vec3(0.0);
    return frame.environment.z * environmentIrradiance(irradianceCube, frame.stack, inEnvironment(direction));
}
