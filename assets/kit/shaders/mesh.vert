// Meshes of all kinds.
#include "frame.glsl"
#include "draw.glsl"
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec2 uv;
GG_VARYING(0) out vec3 vPosition;
GG_VARYING(1) out vec3 vNormal;
GG_VARYING(2) out vec2 vUv;
void main() {
  vec4 world = ggWorldFromMesh * vec4(position, 1.0);
  vec3 scale2 = vec3(dot(ggWorldFromMesh[0].xyz, ggWorldFromMesh[0].xyz), dot(ggWorldFromMesh[1].xyz, ggWorldFromMesh[1].xyz),
                     dot(ggWorldFromMesh[2].xyz, ggWorldFromMesh[2].xyz));
  vPosition = world.xyz;
  vNormal = mat3(ggWorldFromMesh) * (normal / scale2);
  vUv = uv;
  gl_Position = ggClipFromWorld * world;
}
