// region_surface.glsl: the outputs of opaque.vert, for deferred shading of a solid of glass: its nearest front faces are the first
// layer of the interior G-buffer. Triangles of a fine mesh are a few pixels each: drawn forward, devices that shade blocks of
// pixels would shade most of them several times.
// Limits   no maps but of roughness and no colours of vertices: the layer holds depth, normal and alpha.
#include "interface/region.glsl"
#include "stages/region_pixel.glsl"

vec3 inPosition;
vec3 inNormal;
const vec4 inTangent = vec4(0.0);
const vec4 inColor = vec4(1.0);
const vec4 inUv01 = vec4(0.0);
const vec4 inUv23 = vec4(0.0);
