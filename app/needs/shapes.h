// The shapes of solids, by mesh and body, and what stands for the things of the scene: each worked out once.
#pragma once

#include "needs/proxies.h"
#include "scene/bodies.h"
#include "scene/scene.h"
#include "scene/solid_shape.h"

#include <map>
#include <memory>
#include <utility>
#include <vector>

namespace gg::needs {

class Shapes {
public:
// The shapes of solids, by mesh and body, and what stands for the things of the scene: each worked out once.
#pragma once

#include "needs/proxies.h"
#include "scene/bodies.h"

private:
  const scene::Scene& scene_;
  std::vector<scene::Index> bodies_;
  std::map<std::pair<scene::Index, scene::Index>, scene::SolidShape> shapes_;
  std::shared_ptr<const Proxies> proxies_;
};

} // namespace gg::needs
