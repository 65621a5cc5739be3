// The shapes of solids, each worked out once: by mesh and material.
#pragma once

#include "scene/scene.h"
#include "scene/solid_shape.h"

#include <map>
#include <utility>

namespace gg::needs {

class Shapes {
public:
  explicit Shapes(const scene::Scene& scene) : scene_(scene) {} // must outlive this
  // Of the solid that the instance's primitives of that material make together.
  const scene::SolidShape& of(const scene::Instance& instance, scene::Index material);

private:
  const scene::Scene& scene_;
  std::map<std::pair<scene::Index, scene::Index>, scene::SolidShape> shapes_;
};

} // namespace gg::needs
