#include "scene/undrawn.h"

namespace gg::scene {
namespace {

struct Feature {
  const char* extension;
  bool (*is_used)(const Material&);
};

bool is_glass(const Material& m) {
  return m.transmission > 0.0f && !m.conductor && (m.metallic < 1.0f || m.metallic_roughness_map);
}

constexpr Feature features[] = {
    {"KHR_materials_diffuse_transmission on glass",
     [](const Material& m) { return is_glass(m) && m.diffuse_transmission > 0.0f; }},
};

} // namespace

std::vector<std::string> undrawn(const Scene& scene) {
  std::vector<bool> used(scene.materials.size(), false);
  for (const Instance& instance : scene.instances)
    for (const Primitive& p : scene.meshes[static_cast<std::size_t>(instance.mesh)].primitives)
      used[static_cast<std::size_t>(p.material)] = true;
  std::vector<std::string> result;
  for (const Feature& feature : features)
    for (std::size_t i = 0; i < scene.materials.size(); ++i)
      if (used[i] && feature.is_used(scene.materials[i])) {
        result.emplace_back(feature.extension);
        break;
      }
  return result;
}

} // namespace gg::scene
