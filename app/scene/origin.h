// Single precision has its digits near the origin: so that is where the camera belongs.
#pragma once

#include "scene/scene.h"

#include <vector>

namespace gg::scene {

// A scene whose origin is moved again and again, each time from where everything was at first: nothing is rounded twice.
class Origin {
public:
  // Takes the scene as it is; meshes that lie far from their own origins are moved there (move_origin). The scene must outlive
  // this, and nothing else may move what is in it.
  explicit Origin(Scene& scene);
  // As move_origin() would do it with the scene as it was.
  void move_to(const glm::vec3& origin);

private:
  Scene& scene_;
  std::vector<glm::dvec4> instances_; // the fourth column of each, of recentred meshes
  std::vector<glm::vec3> lights_;
  std::vector<glm::vec4> cameras_;
  Bounds bounds_;
};

// Moves the whole scene, its cameras and its lights with it, so that `origin` (in the world before) becomes the origin. The
// sums are done in double. A mesh whose vertices lie far from its own origin (more than 16 times its radius) is moved
// there, and its instances the other way, so that what is stored exactly a million metres off is drawn exactly.
void move_origin(Scene& scene, const glm::vec3& origin);

// The same for what is drawn through `camera`, a copy of one of the scene's or one made for it: it stands at the origin then.
void move_origin_to(Camera& camera, Scene& scene);

} // namespace gg::scene
