#include "scene/scene.h"

namespace gg::scene {

float microfacet_alpha(const Material& material) {
  return material.exact_alpha.value_or(material.roughness * material.roughness);
}

std::size_t Scene::triangle_count() const {
  std::size_t count = 0;
  for (const Instance& instance : instances)
    for (const Primitive& primitive : meshes[static_cast<std::size_t>(instance.mesh)].primitives)
      count += indices[static_cast<std::size_t>(primitive.indices)].size() / 3;
  return count;
}

} // namespace gg::scene
