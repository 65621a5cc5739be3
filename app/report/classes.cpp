#include "report/classes.h"

namespace gg::report {

std::string material_class(const scene::Material& m) {
  if (m.unlit) return "unlit";
  if (m.conductor || m.metallic >= 0.5f) return "metal";
  if (m.transmission > 0.5f) return m.thickness > 0.0f ? "glass" : "thin glass";
  if (m.alpha_mode == scene::AlphaMode::blend) return "blended";
  return "dielectric";
}

std::string roughness_band(const scene::Material& m) {
  // A map multiplies the factor: none of it is left where that is 0.
  const float alpha = scene::microfacet_alpha(m);
  if (m.metallic_roughness_map && alpha > 0.0f && !m.exact_alpha) return "textured";
  // The bands' edges are chosen for reading: a mirror, polished, satin, and where lobes no longer
  // look like cones.
  if (alpha <= 0.0f) return "0";
  if (alpha <= 0.1f) return "to .1";
  return alpha <= 0.3f ? "to .3" : "over .3";
}

std::vector<ObjectKind> kinds_of(const scene::Scene& scene) {
  std::vector<ObjectKind> kinds;
  for (const scene::Instance& instance : scene.instances) {
    ObjectKind kind{.material = "", .roughness = "", .shaded = false};
    for (const scene::Primitive& p :
         scene.meshes[static_cast<std::size_t>(instance.mesh)].primitives) {
      const scene::Material& m = scene.materials[static_cast<std::size_t>(p.material)];
      const std::string material = material_class(m);
      kind.material = kind.material.empty() || kind.material == material ? material : "mixed";
      if (m.unlit) continue;
      const std::string band = roughness_band(m);
      kind.roughness = !kind.shaded || kind.roughness == band ? band : "several";
      kind.shaded = true;
    }
    kinds.push_back(kind);
  }
  return kinds;
}

} // namespace gg::report
