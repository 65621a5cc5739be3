#include "scene/load.h"

#include "scene/apply.h"
#include "scene/brushing.h"
#include "scene/compact.h"
#include "scene/gltf/accessors.h"
#include "scene/gltf/animation.h"
#include "scene/gltf/document.h"
#include "scene/gltf/extras.h"
#include "scene/gltf/fail.h"
#include "scene/gltf/geometry.h"
#include "scene/gltf/images.h"
#include "scene/gltf/lights.h"
#include "scene/gltf/materials.h"
#include "scene/gltf/nodes.h"

#include <fmt/format.h>
#include <glm/gtc/type_ptr.hpp>

#include <map>

namespace gg::scene {
namespace {

using namespace gltf;

// Puts meshes into the world, building each the first time that it is met.
class Placer {
public:
  Placer(Document& document, const Hierarchy& hierarchy, Scene& scene)
      : document_(document), hierarchy_(hierarchy), scene_(scene), geometry_(document, scene) {}

  void place(const Placed& placed) {
    const auto& node = document_.model().nodes[static_cast<std::size_t>(placed.node)];
    if (node.mesh < 0) return;
    const Pose pose = pose_of(node);
    const Index mesh = mesh_of(node, pose);
    if (scene_.meshes[static_cast<std::size_t>(mesh)].primitives.empty()) return;
    Instance instance;
    instance.mesh = mesh;
    instance.name = node.name;
    // The vertices of a skin are in the world already; its joints decide which side is outside.
    if (pose.joints.empty()) instance.world = placed.world;
    const glm::mat3 m(pose.joints.empty() ? placed.world : pose.joints.front());
    instance.mirrored = glm::determinant(glm::dmat3(m)) < 0.0;
    scene_.instances.push_back(std::move(instance));
  }

private:
  Pose pose_of(const tinygltf::Node& node) {
    const auto& mesh = document_.model().meshes[static_cast<std::size_t>(node.mesh)];
    Pose pose;
    pose.weights = node.weights.empty() ? mesh.weights : node.weights;
    if (node.skin >= 0) pose.joints = joints_of(node.skin);
    return pose;
  }

  // Joint in the world times inverse bind matrix, per joint.
  std::vector<glm::mat4> joints_of(int index) {
    const auto& skin = document_.model().skins[static_cast<std::size_t>(index)];
    const std::string place = element("skins", index);
    if (skin.joints.empty()) fail(document_.name(), place + ".joints", "is empty");
    std::vector<float> inverse_binds;
    if (skin.inverseBindMatrices >= 0) {
      const auto& accessor =
          document_.model().accessors[static_cast<std::size_t>(skin.inverseBindMatrices)];
      if (component_count(accessor) != 16 || accessor.count < skin.joints.size())
        fail(document_.name(), place + ".inverseBindMatrices",
             fmt::format("is not {} 4x4 matrices, one per joint", skin.joints.size()));
      inverse_binds = read_floats(document_, skin.inverseBindMatrices);
    }
    std::vector<glm::mat4> joints;
    for (std::size_t i = 0; i < skin.joints.size(); ++i) {
      const glm::mat4& world = hierarchy_.world_of(skin.joints[i]);
      joints.push_back(
          inverse_binds.empty() ? world : world * glm::make_mat4(inverse_binds.data() + 16 * i));
    }
    return joints;
  }

  Index mesh_of(const tinygltf::Node& node, const Pose& pose) {
    const std::pair key{node.mesh, pose.weights};
    if (const auto known = meshes_.find(key); known != meshes_.end() && pose.joints.empty())
      return known->second;
    const auto& source = document_.model().meshes[static_cast<std::size_t>(node.mesh)];
    Mesh mesh;
    mesh.name = source.name;
    for (std::size_t i = 0; i < source.primitives.size(); ++i) {
      const std::string place = fmt::format("meshes[{}].primitives[{}]", node.mesh, i);
      const Index material = material_of(source.primitives[i]);
      const auto frame = tangent_frame(scene_.materials[static_cast<std::size_t>(material)]);
      auto primitive = geometry_.build(source.primitives[i], place, frame, pose);
      if (!primitive) continue;
      primitive->material = material;
      say_what_lacks_coordinates(*primitive, place);
      mesh.primitives.push_back(std::move(*primitive));
    }
    scene_.meshes.push_back(std::move(mesh));
    const auto index = static_cast<Index>(scene_.meshes.size()) - 1;
    if (pose.joints.empty()) meshes_[key] = index;
    return index;
  }

  void say_what_lacks_coordinates(const Primitive& primitive, const std::string& place) {
    Material& material = scene_.materials[static_cast<std::size_t>(primitive.material)];
    for (const Slot* slot : slots(material)) {
      const auto set = static_cast<std::size_t>(slot->uv_set);
      if (!*slot || (set < primitive.uvs.size() && primitive.uvs[set] != none)) continue;
      note(fmt::format(
          "{}: {} has no TEXCOORD_{}, which a texture of its material '{}' needs; drawn "
          "without that texture",
          document_.name(), place, slot->uv_set, material.name));
    }
  }

  Index material_of(const tinygltf::Primitive& primitive) {
    if (primitive.material >= 0) return primitive.material;
    if (default_material_ == none) {
      scene_.materials.push_back(default_material());
      default_material_ = static_cast<Index>(scene_.materials.size()) - 1;
    }
    return default_material_;
  }

  Document& document_;
  const Hierarchy& hierarchy_;
  Scene& scene_;
  Geometry geometry_;
  std::map<std::pair<int, std::vector<double>>, Index> meshes_;
  Index default_material_ = none;
};

std::vector<bool> materials_used(const Scene& scene) {
  std::vector<bool> used(scene.materials.size(), false);
  for (const Mesh& mesh : scene.meshes)
    for (const Primitive& primitive : mesh.primitives)
      used[static_cast<std::size_t>(primitive.material)] = true;
  return used;
}

// A map can only lower the factor: where its metallic channel is 0 everywhere, nothing is metal.
void rule_out_metal(Scene& scene) {
  std::map<const image::Image8*, bool> is_black; // the channel
  for (Material& material : scene.materials) {
    if (!material.metallic_roughness_map || material.metallic == 0.0f) continue;
    const Index image =
        scene.textures[static_cast<std::size_t>(material.metallic_roughness_map.texture)].image;
    if (image == none || static_cast<std::size_t>(image) >= scene.images.size()) continue;
    const image::Image8* map = scene.images[static_cast<std::size_t>(image)].get();
    if (!map) continue;
    const auto [known, is_new] = is_black.try_emplace(map, true);
    for (std::size_t i = 2; is_new && known->second && i < map->rgba.size(); i += 4)
      known->second = map->rgba[i] == 0;
    if (known->second) material.metallic = 0.0f;
  }
}

} // namespace

struct File::Contents {
  explicit Contents(const std::filesystem::path& file) : path(file.string()), document(file) {}
  std::string path;
  Document document;
  std::optional<std::vector<std::shared_ptr<const image::Image8>>> images; // decoded
};

File::File(const std::filesystem::path& path) : contents_(std::make_unique<Contents>(path)) {}
File::~File() = default;

Scene load(const std::filesystem::path& path, const std::optional<Instant>& instant) {
  return File(path).at(instant);
}

Scene File::at(const std::optional<Instant>& instant) {
  Document& document = contents_->document;
  document.restart_budget();
  Scene scene;
  scene.path = contents_->path;
  scene.animations = animation_names(document);
  if (instant)
    scene.posed = pose_at(document, *instant);
  else if (!scene.animations.empty())
    note(document.name()
         + ": has animations; it is shown as its nodes stand, or at a time of them by --time");
  const Hierarchy hierarchy(document);
  read_textures(document, scene);
  for (int i = 0; i < static_cast<int>(document.model().materials.size()); ++i)
    scene.materials.push_back(read_material(document, i));
  {
    Placer placer(document, hierarchy, scene);
    for (const Placed& placed : hierarchy.placed())
      placer.place(placed);
  }
  const std::vector<bool> used = materials_used(scene);
  for (Index i = 0; i < static_cast<Index>(document.model().materials.size()); ++i)
    if (!used[static_cast<std::size_t>(i)])
      continue; // what is wrong with it harms nothing
    else if (const auto setting = setting_in_extras(document, i))
      apply_setting(*setting, extent_of(scene, i), scene.materials[static_cast<std::size_t>(i)]);
  complete_brushing(scene);
  compact(scene);
  scene.bounds = world_bounds(scene);
  if (scene.instances.empty()) note(document.name() + ": has nothing in its scene to draw");
  if (!scene.bounds.empty() && !(scene.bounds.radius() <= largest_radius))
    fail(document.name(), "", fmt::format("the scene spans {} m", 2.0f * scene.bounds.radius()),
         "Check the scale of its nodes.");
  read_cameras(document, hierarchy, scene);
  read_lights(document, hierarchy, scene);
  if (contents_->images) {
    scene.images = *contents_->images;
  } else {
    decode_images(document, used, scene);
    contents_->images = scene.images;
  }
  rule_out_metal(scene);
  return scene;
}

} // namespace gg::scene
