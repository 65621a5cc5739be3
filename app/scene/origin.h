// Single precision has its digits near the origin: so that is where the camera belongs.
#pragma once

#include "scene/scene.h"

namespace gg::scene {

// Moves the whole scene, its cameras and its lights with it, so that `origin` (in the world before) becomes the origin. The
// sums are done in double. A mesh whose vertices lie far from its own origin (more than 16 times its radius) is moved
// there, and its instances the other way, so that what is stored exactly a million metres off is drawn exactly.
void move_origin(Scene& scene, const glm::vec3& origin);

// The same for what is drawn through `camera`, a copy of one of the scene's or one made for it: it stands at the origin then.
void move_origin_to(Camera& camera, Scene& scene);

} // namespace gg::scene
