// The scene's triangles and where rays meet them, by Embree. Every instance is laid out in world
// space.
#pragma once

#include "scene/scene.h"
#include "truth/camera.h"
#include "truth/neighbourhoods.h"

#include <memory>
#include <optional>
#include <vector>

namespace gg::truth {

// One primitive of one instance: what Embree calls a geometry.
struct Part {
  const scene::Primitive* primitive = nullptr;
  const scene::Material* material = nullptr;
  scene::Index instance = scene::none, material_index = scene::none;
  glm::dmat4 world_from_mesh{1.0};
  glm::dmat3 normal_from_mesh{1.0}; // inverse transpose, up to a positive factor
  bool mirrored = false;            // the front faces are clockwise
  bool one_sided = false;           // not there for a ray that comes from behind
  bool solid = false;               // bounds a volume that it has inside (scene/bodies.h)
  bool meets_others = false;        // its bounds and those of another part overlap
};

struct Hit {
  const Part* part = nullptr;
  std::uint32_t vertices[3] = {0, 0, 0}; // into the primitive's streams
  glm::dvec3 weights{0.0};               // of the three vertices: barycentric
  glm::dvec3 position{0.0};              // world, metres
  glm::dvec3 normal{0.0};                // the triangle's, unit, on its front side
  glm::dvec3 smooth{0.0}; // the vertices', unit each, interpolated; on the front side
  double scale = 0.0; // metres: the larger of the position's and the triangle's size, for `leave`
  bool near_others = false; // triangles of other parts may be where this one is
};

class Geometry {
public:
  // Takes the parts' order: part i of `parts()` is the i-th primitive of the instances in order.
  // Throws Error(internal) if Embree cannot be started or is out of memory.
  explicit Geometry(const scene::Scene& scene);
  ~Geometry();
  Geometry(Geometry&&) noexcept;

  const std::vector<Part>& parts() const { return parts_; }

  // The nearest triangle along the ray. One-sided surfaces are met from their front only.
  std::optional<Hit> intersect(const Ray& ray) const;
  // Of all other parts, the triangles that lie where the hit does, as `leave` tells places apart, for
  // a ray in this direction; one a part. Where one is met, the others are passed with it.
  std::vector<Hit> touching(const Hit& hit, const glm::dvec3& direction) const;
  // Is there any triangle on the ray?
  bool occluded(const Ray& ray) const;

  // Where a ray leaves a hit in direction w: the hit, moved off the triangle to the side that w
  // points to, so that rounding does not let it meet the same triangle again.
  glm::dvec3 leave(const Hit& hit, const glm::dvec3& w) const;

private:
  struct Embree;
  // What a hit asks of its triangle, in two lines of cache: memory is what waits longest here.
  struct alignas(32) Triangle {
    glm::vec3 corners[3]; // relative to the centre, as Embree has them
    glm::vec3 normals[3]; // the vertices', world, unit; 0 if there is none
    std::uint32_t vertices[3];
    bool near_others;
  };
  void add_triangles(const scene::Scene& scene, const Part& part);
  void find_neighbours(const scene::Scene& scene);
  Hit hit_of(unsigned geometry, unsigned triangle, double u, double v) const;
  std::vector<Part> parts_;
  glm::dvec3 centre_{0.0}; // of the scene: Embree's coordinates are relative to it
  std::vector<Triangle> triangles_;
  std::vector<std::size_t> first_triangle_;      // of each part
  std::optional<Neighbourhoods> neighbourhoods_; // if any part's bounds overlap another's
  std::unique_ptr<Embree> embree_;
};

} // namespace gg::truth
