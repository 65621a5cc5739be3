// An environment on the device: the sharp cube, its Gaussian levels of known sigma, and diffuse irradiance.
#pragma once

#include "environment/map.h"
#include "environment/sun.h"
#include "gpu/device.h"

#include <glm/vec4.hpp>

#include <memory>
#include <vector>

namespace gg::environment {

// Read by shaders/environment/gaussian_stack_fetch.glsl. Stored units are a power of two of radiance, so that the brightest
// pixel fits a half float: radiance = unit * texel.
struct Stack {
  gpu::TextureRef
      even; // samplerCube: level 0 the map itself, level k >= 1 sigma 2.5 / its texels per edge
  gpu::TextureRef
      odd; // samplerCube: sigma sqrt(2) times that, from the size of even's level 1 down
  gpu::TextureRef irradiance; // samplerCube: mean radiance with weight cos / pi
  gpu::SamplerRef sampler;    // for all three
  glm::vec4 shape{
      0.0f}; // `stack` of gaussian_stack.glsl: sigma of even 0 and even 1 as read, levels past it, unit
  float unit = 1.0f;
  Sun sun; // of the map's frame
};

// sigma of the texels of a level, radians: the Gaussian between the map's pixels, taken as points, and the texels.
struct Level {
  const gpu::Texture* cube;
  int level;
  double sigma;
};
std::vector<Level> levels(const Stack& stack); // by growing sigma

// Computes the stack. Deterministic. With `times`, what each step took on the device is appended (which waits for it).
// Throws Error(device) as the device does.
Stack build(gpu::Device& device, const Map& map, std::vector<gpu::PassTime>* times = nullptr);

// The same for a program that runs again: read from the cache directory if an earlier run has kept it there (kept_stack.h).
Stack build_or_load(gpu::Device& device, const Map& map);

// That, a little at a time: for a window that goes on drawing meanwhile. On the device's thread.
class Building {
public:
  Building(gpu::Device& device, const Map& map);
  ~Building(); // waits for what other threads work out for it
  // A step of the work on the device, or nothing while other threads are not ready for it. Returns whether all is done.
  bool advance();
  double progress() const;    // of the work, 0 to 1
  const Stack& stack() const; // when all is done

  class Builder; // of stack.cpp

private:
  std::unique_ptr<Builder> builder_;
};

// Bytes of the cubes that build() leaves on a device.
std::size_t bytes_of(const Map& map);

} // namespace gg::environment
