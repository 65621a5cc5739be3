// The shapes of solids, by mesh and body, and the proxies of the scene: each computed once.
#pragma once

#include "needs/hollows.h"
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
  explicit Shapes(const scene::Scene& scene); // must outlive this
  // The scene's instances have been moved, or its materials changed: what depends on them is worked out again.
  void scene_changed();
  void geometry_changed(); // and its meshes with them
  // The body of this material, as the first of its materials (scene/bodies.h).
  scene::Index body(scene::Index material) const {
    return bodies_[static_cast<std::size_t>(material)];
  }
  // Of the solid that the instance's primitives of that body make together.
  const scene::SolidShape& of(const scene::Instance& instance, scene::Index body_of);
  // Of the whole scene (needs/proxies.h).
  std::shared_ptr<const Proxies> proxies();
  // As its instances stand at the first call: half a second for each move would be long.
  std::shared_ptr<const Hollows> hollows();

private:
  const scene::Scene& scene_;
  std::vector<bool> solid_; // by material: bodies depend on no more of them
  std::vector<scene::Index> bodies_;
  std::map<std::pair<scene::Index, scene::Index>, scene::SolidShape> shapes_;
  std::shared_ptr<const Proxies> proxies_;
  std::shared_ptr<const Hollows> hollows_;
};

} // namespace gg::needs
