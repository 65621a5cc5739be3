// A single-channel picture on the sphere and its Gaussian levels, on the host: what the tables' Gaussians are fitted on.
#pragma once

#include <glm/vec3.hpp>

#include <functional>
#include <vector>

namespace gg::tables {

// A cube map of one channel; texel (x, y) of face f is texels[(f * size + y) * size + x].
struct SphereMap {
  int size = 0;
  std::vector<float> texels;

  explicit SphereMap(int texels_per_edge = 0)
      : size(texels_per_edge), texels(6 * static_cast<std::size_t>(texels_per_edge)
                                      * static_cast<std::size_t>(texels_per_edge)) {}
  float& at(int face, int x, int y) {
    return texels[static_cast<std::size_t>((face * size + y) * size + x)];
  }
  float at(int face, int x, int y) const {
    return texels[static_cast<std::size_t>((face * size + y) * size + x)];
  }
  // Bilinear within the face that the direction (any length but 0) hits, without looking across its edges.
  float radiance(const glm::vec3& direction) const;
};

// `radiance(direction)` averaged over a grid of points in every texel. Parallel.
SphereMap sample_sphere(int size, const std::function<float(const glm::vec3&)>& radiance);

// Averages of 2 x 2 texels, weighted by solid angle.
SphereMap halved(const SphereMap& map);

// Maps of one size, at least one, convolved with the Gaussian of that variance (rad²) on their own lattice: together, as a kernel's
// weights cost more than what they are multiplied with. Parallel.
std::vector<SphereMap> blurred(const std::vector<SphereMap>& maps, double variance);

// A map at growing sigma, sqrt(2) apart.
class SphereStack {
public:
  static double first_sigma(int size);

  // Mixed from the two levels next to sigma as shaders/environment/gaussian_stack.glsl says.
  float radiance(const glm::vec3& direction, double sigma) const;
  // From the one level whose sigma is nearest.
  float radiance_nearest(const glm::vec3& direction, double sigma) const;
  int nearest_level(double sigma) const;
  const SphereMap& level(int k) const { return levels_[static_cast<std::size_t>(k)]; }
  int level_count() const { return static_cast<int>(levels_.size()); }
  double sigma(int k) const { return sigmas_[static_cast<std::size_t>(k)]; }

  double geometric_mean = 0.0; // of the sharp map's radiance

private:
  friend std::vector<SphereStack> stacks_of(const std::vector<SphereMap>& maps);
  explicit SphereStack(SphereMap map);
  std::vector<SphereMap> levels_;
  std::vector<double> sigmas_;
};

// A stack of each map; all are of one size. Level 0 is the map itself, level k >= 1 has sigma first_sigma(size) sqrt(2)^(k-1), up to
// about 1.3 rad.
std::vector<SphereStack> stacks_of(const std::vector<SphereMap>& maps);

} // namespace gg::tables
