// The uniform blocks of shaders/interface, as C++ sees them. The layouts are pinned here.
#pragma once

#include <glm/glm.hpp>

#include <cstddef>

namespace gg::uniforms {

using glm::ivec4;
using glm::mat4;
using glm::vec4;

#include "../../shaders/interface/frame.glsl"
#include "../../shaders/interface/instance.glsl"
#include "../../shaders/interface/lights.glsl"
#include "../../shaders/interface/material.glsl"
#include "../../shaders/interface/neighbours.glsl"
#include "../../shaders/interface/region.glsl"
#include "../../shaders/interface/shadows.glsl"

// std140 and std430 place these types at multiples of 16 bytes with no holes, which is what C++
// does too.
static_assert(offsetof(FrameData, eye) == 128 && sizeof(FrameData) == 512);
static_assert(offsetof(InstanceData, normalFromMesh) == 64 && sizeof(InstanceData) == 128);
static_assert(offsetof(LightData, cone) == 48 && sizeof(LightData) == 64);
static_assert(offsetof(MaterialData, baseColorRow0) == 192 && sizeof(MaterialData) == 736);
static_assert(sizeof(NeighbourData) == 112 && offsetof(NeighboursData, each) == 16);
static_assert(sizeof(RegionData) == 32);
static_assert(sizeof(ShadowViewData) == 144);

} // namespace gg::uniforms
