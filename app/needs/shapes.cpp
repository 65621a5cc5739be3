#include "needs/shapes.h"

#include <vector>

namespace gg::needs {

const scene::SolidShape& Shapes::of(const scene::Instance& instance, scene::Index body_of) {
  const auto [at, is_new] = shapes_.try_emplace({instance.mesh, body_of});
  if (!is_new) return at->second;
  std::vector<const scene::Primitive*> parts;
  for (const scene::Primitive& p :
       scene_.meshes[static_cast<std::size_t>(instance.mesh)].primitives)
    if (body(p.material) == body_of) parts.push_back(&p);
  return at->second = scene::solid_shape(scene_, parts);
}

std::shared_ptr<const Proxies> Shapes::proxies() {
  if (!proxies_) proxies_ = std::make_shared<const Proxies>(proxies_of(scene_));
  return proxies_;
}

} // namespace gg::needs
