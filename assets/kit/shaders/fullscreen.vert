// One triangle over the whole picture; depth at the far plane.
#include "frame.glsl"
GG_VARYING(0) out vec2 vPlace; // [0, 1]²
void main() {
  vPlace = vec2(GG_VERTEX == 1 ? 2.0 : 0.0, GG_VERTEX == 2 ? 2.0 : 0.0);
  gl_Position = vec4(2.0 * vPlace - 1.0, 1.0, 1.0);
}
