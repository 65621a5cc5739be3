#include "needs/shapes.h"

#include <vector>

namespace gg::needs {

const scene::SolidShape& Shapes::of(const scene::Instance& instance, scene::Index material) {
  const auto [at, is_new] = shapes_.try_emplace({instance.mesh, material});
  if (!is_new) return at->second;
  std::vector<const scene::Primitive*> parts;
  for (const scene::Primitive& p :
       scene_.meshes[static_cast<std::size_t>(instance.mesh)].primitives)
    if (p.material == material) parts.push_back(&p);
  return at->second = scene::solid_shape(scene_, parts);
}

} // namespace gg::needs
