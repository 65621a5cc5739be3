// region_surface.glsl: what opaque.vert would have sent, for a solid of glass that is shaded by the pixels of its region: its
// nearest front faces are the first layer of the interior already. Triangles of a fine mesh are a few pixels each, and machines
// that shade blocks of pixels would shade most of them several times.
// Limits   no maps and no colours of vertices: the layer holds depth, normal and alpha.
#include "interface/region.glsl"
#include "stages/region_pixel.glsl"

vec3 inPosition;
vec3 inNormal;
const vec4 inTangent = vec4(0.0);
const vec4 inColor = vec4(1.0);
const vec4 inUv01 = vec4(0.0);
const vec4 inUv23 = vec4(0.0);
