// Cameras and KHR_lights_punctual.
#pragma once

#include "scene/gltf/document.h"
#include "scene/gltf/nodes.h"
#include "scene/scene.h"

namespace gg::scene::gltf {

// A camera is called after its node, or after itself where the node has no name. A node's scale
// does not act on a camera.
void read_cameras(const Document& document, const Hierarchy& hierarchy, Scene& scene);

void read_lights(const Document& document, const Hierarchy& hierarchy, Scene& scene);

} // namespace gg::scene::gltf
