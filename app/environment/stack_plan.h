// Which levels a stack has, how wide each is, and by which steps one comes from another: numbers alone, without a device.
#pragma once

#include "environment/map.h"

#include <glm/ext/vector_int4.hpp>
#include <glm/vec4.hpp>

#include <vector>

namespace gg::environment {

using glm::ivec4;
using glm::vec4;
#include "../../shaders/interface/environment_step.glsl"
static_assert(sizeof(EnvironmentStep) == 32);

// Sizes are in texels along a face's edge, sigma in radians.

constexpr int smallest_level = 4, irradiance_face = 16;
// Up to this size of result the kernel is convolved over all pairs, from the odd level of twice the size.
constexpr int zonal_face = 8;
// Where the sum over the picture's pixels ends, in sigma of the sharp level.
constexpr double equirect_reach = 4.0;

// The map with as many pixels as the sizes of stacks allow for.
Map fitted(const Map& map);
// Of the sharp level of a fitted map.
int face_of(const Map& map);
double sharp_sigma(const Map& map);

// Even levels go from the sharp one down to smallest_level, odd ones from half of it: one less.
int even_level_count(int face);
double even_sigma(int size);
double odd_sigma(int size);
// What a bilinear lookup adds to a level's variance per axis, on average.
double lookup_variance(int size);

// A level: of the odd ones level 0 is half the sharp one's size.
struct Place {
  bool odd = false;
  int level = 0;
  int size = 0;
};

// A Gaussian step from the level before it, in the order of growing sigma. Its kernel's variance is what it adds.
struct Blur {
  Place to;
  EnvironmentStep step{};
};

struct Wide {
  Place to;
  double variance = 0.0; // what it adds to the last of the blurs
};

struct StackPlan {
  EnvironmentStep sharp{}; // the picture onto the sharp level
  std::vector<Blur> blurs;
  std::vector<Wide> wide; // by growing sigma
  Place irradiance_source;
};
StackPlan plan_stack(const Map& map);

} // namespace gg::environment
