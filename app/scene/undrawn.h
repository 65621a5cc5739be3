// What a scene asks for that a frame may not draw yet.
#pragma once

#include "scene/scene.h"

#include <string>
#include <vector>

namespace gg::scene {

// What among anisotropy, clearcoat and iridescence on glass, and diffuse transmission, some drawn
// material really uses (a factor other than 0), by glTF name and in that order. They are read into
// Material; whoever draws the scene without one of them says so.
std::vector<std::string> undrawn(const Scene& scene);

} // namespace gg::scene
