// engine.glsl: what an engine supplies for rough refraction: six functions that read its textures. They are declared here and
// defined by you, after this file.
// Frame    world, metres; at of the scene: pixels of the scene colour, (0.5, 0.5) the centre of the one that is shown top left.
// alpha    none; sigma: radians per axis; variance: pixels² per axis.
// Returns  engineInterfaceEnergy, engineInterfaceLobe: a texel of the tables of one interface at a coordinate in [0, 1]³
//          (interface_table.glsl: interface-energy, interface-lobes2), filtered linearly, clamped. engineReflectionLobe: the same
//          of lobe_table.glsl's reflection-lobes1. engineSceneColor: linear
//          radiance of the scene without glass, blurred by a Gaussian (screen_pyramid.glsl), in rgb, multiplied by w, the share of
//          the blur that may be seen through the glass: 1 if nothing is cut out. engineSceneDepth: metres from the camera along
//          its axis, 1e30 for the sky. engineEnvironment: linear radiance blurred by a Gaussian (gaussian_stack.glsl).
// Source   none.
// Limits   places outside of the scene's colour and depth are asked for: clamp to the edge.
#ifndef GG_REFRACTION_ENGINE_GLSL
#define GG_REFRACTION_ENGINE_GLSL

vec4 engineInterfaceEnergy(vec3 at);
vec4 engineInterfaceLobe(vec3 at);
vec4 engineReflectionLobe(vec3 at);
vec4 engineSceneColor(vec2 at, float variance);
float engineSceneDepth(vec2 at);
vec3 engineEnvironment(vec3 direction, float sigma);

#endif
