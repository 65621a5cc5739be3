// The OpenGL 4.5 entry points of one context (glad, generated when building).
#pragma once

#include <glad/gl.h>
