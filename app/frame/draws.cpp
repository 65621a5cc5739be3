#include "frame/draws.h"

#include <algorithm>

namespace gg::frame {
namespace {

// Attribute locations of stages/opaque.vert; each has a vertex binding of its own, as glTF's
// streams are separate.
constexpr int position_location = 0, normal_location = 1, tangent_location = 2, color_location = 3,
              uv_location = 4;

struct MapName {
  const char* name;
  scene::Slot scene::Material::*slot;
  Feature feature;
  bool srgb;
};
constexpr MapName maps[] = {
    {"baseColorMap", &scene::Material::base_color_map, Feature::base_color_map, true},
    {"metallicRoughnessMap", &scene::Material::metallic_roughness_map,
     Feature::metallic_roughness_map, false},
    {"normalMap", &scene::Material::normal_map, Feature::normal_map, false},
    {"occlusionMap", &scene::Material::occlusion_map, Feature::occlusion_map, false},
    {"emissiveMap", &scene::Material::emissive_map, Feature::emissive_map, true},
    {"specularMap", &scene::Material::specular_map, Feature::specular_map, false},
    {"specularColorMap", &scene::Material::specular_color_map, Feature::specular_color_map, true},
    {"transmissionMap", &scene::Material::transmission_map, Feature::transmission_map, false},
    {"thicknessMap", &scene::Material::thickness_map, Feature::thickness_map, false},
};

int value_of(const FeatureKey& key, Feature feature) {
  return key[static_cast<std::size_t>(feature)];
}

// The inputs of stages/opaque.vert that are left when it is specialised.
struct Input {
  int location, components;
};
std::vector<Input> attributes_of(const FeatureKey& key) {
  std::vector<Input> inputs{{position_location, 3}, {normal_location, 3}};
  if (value_of(key, Feature::normal_map) > 0) inputs.push_back({tangent_location, 4});
  if (value_of(key, Feature::vertex_color) > 0) inputs.push_back({color_location, 4});
  for (int k = 0; k < value_of(key, Feature::uv_sets); ++k)
    inputs.push_back({uv_location + k, 2});
  return inputs;
}

// The streams that feed them, in the same order.
std::vector<scene::Index> streams_of(const FeatureKey& key, const scene::Primitive& p,
                                     const std::vector<int>& uv_sets) {
  std::vector<scene::Index> streams{p.positions, p.normals};
  if (value_of(key, Feature::normal_map) > 0) streams.push_back(p.tangents);
  if (value_of(key, Feature::vertex_color) > 0) streams.push_back(p.colors);
  for (const int set : uv_sets)
    streams.push_back(p.uvs[static_cast<std::size_t>(set)]);
  return streams;
}

scene::Bounds world_bounds(const scene::Bounds& bounds, const glm::mat4& world) {
  scene::Bounds result;
  if (bounds.empty()) return result;
  for (unsigned corner = 0; corner < 8; ++corner)
    result.include(glm::vec3(world
                             * glm::vec4(corner & 1u ? bounds.high.x : bounds.low.x,
                                         corner & 2u ? bounds.high.y : bounds.low.y,
                                         corner & 4u ? bounds.high.z : bounds.low.z, 1.0f)));
  return result;
}

// Whether something opaque reaches into the box around a solid. What stands on the floor touches it:
// a thousandth of the solid's size does not count.
bool holds_opaque(const Draw& solid, const std::vector<Draw>& draws) {
  if (!(solid.material->thickness > 0.0f)) return false;
  const glm::vec3 least(1e-3f * solid.bounds.radius());
  return std::ranges::any_of(draws, [&](const Draw& other) {
    return other.role == Role::opaque
           && glm::all(glm::greaterThan(other.bounds.high, solid.bounds.low + least))
           && glm::all(glm::lessThan(other.bounds.low, solid.bounds.high - least));
  });
}

Role role_of(const scene::Material& material) {
  if (is_refractive(material)) return Role::refractive;
  return material.alpha_mode == scene::AlphaMode::blend ? Role::blended : Role::opaque;
}

} // namespace

tables::Model model_of(const scene::Material& material, bool correlated_smith) {
  switch (material.distribution) {
  case scene::Distribution::ggx:
    return {tables::Distribution::ggx,
            correlated_smith ? tables::Smith::correlated : tables::Smith::separable};
  case scene::Distribution::beckmann:
    return {tables::Distribution::beckmann, tables::Smith::separable};
  case scene::Distribution::phong:
    return {tables::Distribution::phong, tables::Smith::separable};
  }
  return {};
}

Draws::Draws(gpu::Device& device, const UploadedScene& uploaded, const tables::DeviceTables& tables,
             const FrameFeatures& features, const scene::Camera& camera)
    : device_(device), uploaded_(uploaded), tables_(tables), features_(features) {
  const scene::Scene& scene = uploaded.scene();
  const glm::vec3 eye(camera.world[3]);
  const glm::vec3 forward = -glm::normalize(glm::vec3(camera.world[2]));
  for (std::size_t i = 0; i < scene.instances.size(); ++i) {
    const scene::Instance& instance = scene.instances[i];
    for (const scene::Primitive& primitive :
         scene.meshes[static_cast<std::size_t>(instance.mesh)].primitives) {
      Draw draw;
      draw.primitive = &primitive;
      draw.material_index = static_cast<std::size_t>(primitive.material);
      draw.material = &scene.materials[draw.material_index];
      draw.instance_index = i;
      draw.role = role_of(*draw.material);
      draw.key = features_of(*draw.material, primitive, features);
      draw.bounds = world_bounds(primitive.bounds, instance.world);
      const glm::vec3 centre(instance.world * glm::vec4(primitive.bounds.centre(), 1.0f));
      draw.distance = static_cast<double>(glm::dot(centre - eye, forward));
      draw.streams = streams_of(draw.key, primitive, uv_sets_of(*draw.material, primitive));
      for (const MapName& map : maps)
        if (value_of(draw.key, map.feature) > 0) {
          draw.maps.push_back(
              {map.name, uploaded.texture((draw.material->*map.slot).texture, map.srgb)});
          sampled_.push_back(draw.maps.back().texture.view);
        }
      draw.index_count = static_cast<std::uint32_t>(
          scene.indices[static_cast<std::size_t>(primitive.indices)].size());
      draw.mirrored = instance.mirrored;
      draw.both_sides = draw.material->double_sided;
      draws_.push_back(std::move(draw));
    }
  }
  for (Draw& draw : draws_)
    if (draw.role == Role::refractive)
      draw.key[static_cast<std::size_t>(Feature::holds_opaque)] = holds_opaque(draw, draws_);
  for (const tables::ModelTables& model : tables.of_model)
    for (const gpu::TextureRef& table :
         {model.energy, model.lobe, model.interface_energy, model.interface_lobes})
      if (table) sampled_.push_back(gpu::whole(table));
}

std::vector<const Draw*> Draws::of(Role role) const {
  std::vector<const Draw*> found;
  for (const Draw& draw : draws_)
    if (draw.role == role) found.push_back(&draw);
  const double sign = role == Role::opaque ? 1.0 : -1.0;
  std::ranges::stable_sort(found, std::less{},
                           [sign](const Draw* draw) { return sign * draw->distance; });
  return found;
}

std::size_t Draws::triangle_count() const {
  std::size_t count = 0;
  for (const Draw& draw : draws_)
    count += draw.index_count / 3;
  return count;
}

gpu::PipelineRef Draws::pipeline(const DrawPass& pass, const Draw& draw) {
  gpu::PipelineRef& found = pipelines_[{pass.label, draw.key}];
  if (found) return found;
  gpu::PipelineDesc desc{.label = pass.label,
                         .vertex = "opaque.vert",
                         .fragment = pass.fragment,
                         .constants = constants_of(draw.key),
                         .colors = pass.colors,
                         .depth = pass.depth,
                         .depth_write = pass.depth_write,
                         .depth_compare = pass.depth_compare,
                         .blend = pass.blend};
  desc.constants.insert(desc.constants.end(), pass.constants.begin(), pass.constants.end());
  for (const auto& [location, components] : attributes_of(draw.key)) {
    desc.attributes.push_back({.location = location,
                               .components = components,
                               .binding = static_cast<int>(desc.bindings.size())});
    desc.bindings.push_back({.stride = static_cast<std::uint32_t>(components) * 4u});
  }
  found = device_.create(desc);
  return found;
}

void Draws::record(gpu::Encoder& encoder, const gpu::PipelineRef& pipeline,
                   const Draw& draw) const {
  record(encoder, pipeline, draw, draw.both_sides ? gpu::Cull::none : gpu::Cull::back);
}

void Draws::record(gpu::Encoder& encoder, const gpu::PipelineRef& pipeline, const Draw& draw,
                   gpu::Cull cull) const {
  const UniformArray& materials = uploaded_.materials();
  const UniformArray& instances = uploaded_.instances();
  encoder.use(pipeline);
  encoder.buffer("Instance", instances.buffer, instances.offset(draw.instance_index),
                 instances.size);
  encoder.buffer("Material", materials.buffer, materials.offset(draw.material_index),
                 materials.size);
  for (std::size_t k = 0; k < draw.streams.size(); ++k)
    encoder.vertices(static_cast<int>(k), uploaded_.stream(draw.streams[k]));
  const tables::ModelTables& tables =
      tables_.of(model_of(*draw.material, features_.correlated_smith));
  if (tables.energy) {
    encoder.texture("energyTable", gpu::whole(tables.energy), tables_.sampler);
    encoder.texture("lobeTable", gpu::whole(tables.lobe), tables_.sampler);
  }
  if (tables.interface_energy) {
    encoder.texture("interfaceEnergyTable", gpu::whole(tables.interface_energy), tables_.sampler);
    encoder.texture("interfaceLobeTable", gpu::whole(tables.interface_lobes), tables_.sampler);
  }
  for (const Draw::Map& map : draw.maps)
    encoder.texture(map.name, map.texture.view, map.texture.sampler);
  encoder.cull(cull);
  encoder.front_is_clockwise(draw.mirrored);
  encoder.indices(uploaded_.indices(draw.primitive->indices));
  encoder.draw_indexed(draw.index_count);
}

} // namespace gg::frame
