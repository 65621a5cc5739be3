// What the tests of app/environment share: a device, levels read back, and the sphere written down a second time, on purpose
// not by the snippets that are under test.
#pragma once

#include "environment/stack.h"
#include "gpu/device.h"

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <functional>
#include <vector>

namespace gg::environment {

gpu::Device& device(); // one for the process, its driver's messages are errors

// A cube level on the host, in radiance.
struct CubeLevel {
  int size = 0;
  std::vector<glm::dvec3> texels; // face by face, row by row
  const glm::dvec3& at(int face, int x, int y) const {
    return texels[static_cast<std::size_t>((face * size + y) * size + x)];
  }
};
CubeLevel read(const gpu::Texture& cube, int level, float unit);

glm::dvec3 texel_direction(int face, int x, int y, int size); // unit
double texel_solid_angle(int x, int y, int size);             // exact
glm::dvec3 mean(const CubeLevel& level);                      // by solid angle

// A picture with radiance(direction) at the centres of its pixels.
Map picture_of(int width, const std::function<glm::dvec3(const glm::dvec3&)>& radiance);
glm::dvec3 pixel_direction(int width, int height, int x, int y);

// The map convolved with a kernel of the angle, kernel(cos), brute force over all pixels, normalised.
glm::dvec3 convolved(const Map& map, const glm::dvec3& direction,
                     const std::function<double(double)>& kernel);
// exp(-l(l+1) sigma²/2) as a function of the cosine, tabulated from its Legendre series.
std::function<double(double)> heat_kernel(double sigma);

} // namespace gg::environment
