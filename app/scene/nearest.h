// How near the camera a scene comes.
#pragma once

#include "scene/scene.h"

namespace gg::scene {

// A depth, in metres along the camera's axis, before which a perspective camera sees nothing of the scene: that of the
// nearest triangle's nearest corner, or where a triangle reaches past the eye a quarter of its distance from it
// (right for all that is seen up to 75 degrees off the axis). No more than `limit`, and not below 0.
float clear_depth(const Scene& scene, const Camera& camera, float limit);

} // namespace gg::scene
