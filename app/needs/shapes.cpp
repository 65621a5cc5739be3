#include "needs/shapes.h"

#include "needs/kept_hollows.h"

#include <utility>
#include <vector>

namespace gg::needs {
namespace {

std::vector<bool> solids_of(const scene::Scene& scene) {
  std::vector<bool> solid;
  for (const scene::Material& material : scene.materials)
    solid.push_back(scene::is_solid(material));
  return solid;
}

} // namespace

Shapes::Shapes(const scene::Scene& scene)
    : scene_(scene), solid_(solids_of(scene)), bodies_(scene::body_materials(scene)) {}

void Shapes::scene_changed() {
  proxies_.reset();
  std::vector<bool> solid = solids_of(scene_);
  if (solid == solid_) return;
  solid_ = std::move(solid);
  bodies_ = scene::body_materials(scene_);
  shapes_.clear();
  hollows_.reset();
}

void Shapes::geometry_changed() {
  scene_changed();
  shapes_.clear();
}

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

std::shared_ptr<const Hollows> Shapes::hollows() {
  if (!hollows_) hollows_ = std::make_shared<const Hollows>(hollows_kept_or_of(scene_, *proxies()));
  return hollows_;
}

} // namespace gg::needs
