// sky.frag: the environment itself where nothing was drawn, unblurred.
#version 450
#include "interface/frame.glsl"
