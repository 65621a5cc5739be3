#include "shared.glsl"
float usesShared() { return 2.0 * sharedOne(); }
