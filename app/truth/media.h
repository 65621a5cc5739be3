// What a point of space is filled with: air, or one of the scene's solids.
//
// Solids may stand in each other (a bubble in glass, a drink that reaches into its glass). Where
// several overlap, the smallest (by its bounds) fills the place: what is put into something
// displaces it. The answer depends on the point alone, not on the way a path took to it, so
// transport stays reciprocal.
#pragma once

#include "truth/geometry.h"

#include <algorithm>
#include <array>
#include <map>
#include <vector>

namespace gg::truth {

using SolidId = std::int32_t;
inline constexpr SolidId air = -1;
inline constexpr int white = -1;

// The solids that a point is inside of. A mesh whose parts overlap is entered as often as its
// surface is crossed.
class Inside {
public:
  Inside() = default;
  // Paths are copied often, and few are inside of anything.
  Inside(const Inside& other) : count_(other.count_) {
    std::copy_n(other.solids_.data(), count_, solids_.data());
  }
  Inside& operator=(const Inside& other) {
    std::copy_n(other.solids_.data(), other.count_, solids_.data());
    count_ = other.count_;
    return *this;
  }
  void enter(SolidId solid);
  void leave(SolidId solid); // once; nothing if it was not entered
  bool contains(SolidId solid) const;
  bool empty() const { return count_ == 0; }
  const SolidId* begin() const { return solids_.data(); }
  const SolidId* end() const { return solids_.data() + count_; }

private:
  // More than 16 crossings deep the outermost is forgotten: no scene of glass in glass is.
  std::array<SolidId, 16> solids_;
  std::size_t count_ = 0;
};

struct Solid {
  double ior = 1.0;
  double dispersion = 0.0; // 20 / Abbe number
  glm::dvec3 attenuation_color{1.0};
  double attenuation_distance = INFINITY; // metres
  double volume = 0.0;                    // of its bounds: smaller displaces larger
};

// Beer and Lambert: what is left of light after `depth` attenuation distances, at which white has
// this colour (KHR_materials_volume). All of it where depth is not positive.
glm::dvec3 transmittance(const glm::dvec3& color, double depth);

class Media {
public:
  Media(const scene::Scene& scene, const Geometry& geometry);

  // The solid that the part bounds, or air if it bounds none. The parts of one instance whose
  // materials share a body (scene/bodies.h) bound one solid.
  SolidId bounded_by(const Part& part) const;
  // What fills a place that is inside of these.
  SolidId at(const Inside& inside) const;
  // Of two solids at one place, does the first fill it?
  bool displaces(SolidId a, SolidId b) const;
  // For one of the channels red, green and blue, or for light of all of them: `white`.
  double ior(SolidId medium, int channel) const;
  // Does the index depend on the channel?
  bool disperses(SolidId medium) const;
  // What is left of light after `distance` metres, in [0, 1] per channel.
  glm::dvec3 transmittance(SolidId medium, double distance) const;
  bool empty() const { return solids_.empty(); }
  // Does every solid bend light that comes to it from air?
  bool all_bend() const;

private:
  std::vector<Solid> solids_;
  std::vector<SolidId> of_part_;
  const Part* first_ = nullptr;
};

// The solids that contain the point, found by following a ray from it to infinity.
Inside solids_around(const glm::dvec3& point, const Geometry& geometry, const Media& media);

} // namespace gg::truth
