#include "frame/draws.h"

#include "frame/passes/alike.h"
#include "gpu/pipeline_key.h"

#include <utility>

namespace gg::frame {

namespace {

gpu::Cull cull_of(const needs::LayerDraw& draw) {
  switch (draw.faces) {
  case needs::Faces::front:
    return gpu::Cull::back;
  case needs::Faces::back:
    return gpu::Cull::front;
  case needs::Faces::as_material:
    return draw.draw->both_sides ? gpu::Cull::none : gpu::Cull::back;
  }
  return gpu::Cull::none;
}

// As shading deferred has it: what maps, colours of vertices and a mask say has been read, or is in the G-buffer.
needs::FeatureKey without_mesh(needs::FeatureKey key) {
  for (const needs::MapKind& kind : needs::map_kinds)
    set_value(key, kind.feature, 0);
  set_value(key, needs::Feature::vertex_color, 0);
  set_value(key, needs::Feature::uv_sets, 0);
  if (value_of(key, needs::Feature::alpha_mode) == static_cast<int>(scene::AlphaMode::mask))
    set_value(key, needs::Feature::alpha_mode, static_cast<int>(scene::AlphaMode::opaque));
  return key;
}

} // namespace

Draws::Draws(gpu::Device& device, const UploadedScene& uploaded, const tables::DeviceTables& tables)
    : device_(device), uploaded_(uploaded), tables_(tables) {}

std::vector<gpu::View> Draws::sampled() const {
  std::vector<gpu::View> views = uploaded_.sampled();
  for (const tables::ModelTables& model : tables_.of_model)
    for (const gpu::TextureRef& table :
         {model.energy, model.lobe, model.interface_energy, model.interface_lobes,
          model.wall_energy, model.wall_lobes})
      if (table) views.push_back(gpu::whole(table));
  return views;
}

void Draws::expect(const std::function<void()>& what) {
  missing(what);
}

std::vector<gpu::PipelineDesc> Draws::missing(const std::function<void()>& what) {
  expecting_ = true;
  what();
  expecting_ = false;
  device_.expect(expected_);
  return std::exchange(expected_, {});
}

gpu::PipelineRef Draws::pipeline(const gpu::PipelineDesc& desc) {
  gpu::PipelineRef& found = pipelines_[gpu::key_of(desc)];
  if (!found && expecting_) expected_.push_back(desc);
  if (!found && !expecting_) found = device_.create(desc);
  return found;
}

gpu::PipelineRef Draws::pipeline(const DrawPass& pass, const needs::Draw& draw) {
  gpu::PipelineDesc desc{.label = pass.label,
                         .vertex = pass.by_region ? "region.vert" : "opaque.vert",
                         .fragment = pass.fragment,
                         .constants = pass.constants,
                         .colors = pass.colors,
                         .depth = pass.depth,
                         .depth_write = pass.depth_write,
                         .depth_compare = pass.depth_compare,
                         .blend = pass.blend};
  const needs::FeatureKey key = pass.by_region ? without_mesh(draw.key) : draw.key;
  for (std::uint32_t id = 0; id < key.size(); ++id)
    desc.constants.push_back(gpu::constant(id, key[id]));
  if (!pass.by_region)
    for (const needs::VertexInput& input : draw.inputs) {
      desc.attributes.push_back({.location = input.location,
                                 .components = input.components,
                                 .binding = static_cast<int>(desc.bindings.size())});
      desc.bindings.push_back({.stride = static_cast<std::uint32_t>(input.components) * 4u});
    }
  return pipeline(desc);
}

Recorded Draws::recorded(const DrawPass& pass, const needs::LayerDraw& draw) {
  return {draw.draw, pipeline(pass, *draw.draw), cull_of(draw)};
}

Records Draws::covers(const std::vector<needs::LayerDraw>& draws) {
  const DrawPass pass = hiding_pass("covers");
  Records records;
  for (const needs::LayerDraw& draw : draws) {
    if (!draw.draw->fills_depth) continue;
    needs::Draw masked = *draw.draw; // its cutoff is glTF's default, a half
    needs::set_value(masked.key, needs::Feature::alpha_mode,
                     static_cast<int>(scene::AlphaMode::mask));
    records.push_back({draw.draw, pipeline(pass, masked), cull_of(draw)});
  }
  return records;
}

void Draws::bind(gpu::Encoder& encoder, const gpu::PipelineRef& pipeline,
                 const needs::Draw& draw) const {
  const UniformArray& materials = uploaded_.materials();
  const UniformArray& instances = uploaded_.instances();
  encoder.use(pipeline);
  encoder.buffer("Instance", instances.buffer, instances.offset(draw.instance_index),
                 instances.size);
  encoder.buffer("Material", materials.buffer, materials.offset(draw.material_index),
                 materials.size);
  if (!draw.neighbours.empty()) {
    const UniformArray& neighbours = uploaded_.neighbours();
    encoder.buffer("Neighbours", neighbours.buffer,
                   neighbours.offset(uploaded_.neighbour_block(draw)), neighbours.size);
  }
  const tables::ModelTables& tables =
      tables_.of(needs::model_of(*draw.material, uploaded_.needs().view.correlated_smith));
  if (tables.energy) {
    encoder.texture("energyTable", gpu::whole(tables.energy), tables_.sampler);
    encoder.texture("lobeTable", gpu::whole(tables.lobe), tables_.sampler);
  }
  if (tables.interface_energy) {
    encoder.texture("interfaceEnergyTable", gpu::whole(tables.interface_energy), tables_.sampler);
    encoder.texture("interfaceLobeTable", gpu::whole(tables.interface_lobes), tables_.sampler);
  }
  if (tables.wall_energy) {
    encoder.texture("wallEnergyTable", gpu::whole(tables.wall_energy), tables_.sampler);
    encoder.texture("wallLobeTable", gpu::whole(tables.wall_lobes), tables_.sampler);
  }
  for (const needs::Map& map : draw.maps) {
    const UploadedTexture texture = uploaded_.texture(map);
    encoder.texture(map.name, texture.view, texture.sampler);
  }
}

void Draws::record(gpu::Encoder& encoder, const Recorded& recorded) const {
  const needs::Draw& draw = *recorded.draw;
  bind(encoder, recorded.pipeline, draw);
  for (std::size_t k = 0; k < draw.inputs.size(); ++k)
    encoder.vertices(static_cast<int>(k), uploaded_.stream(draw.inputs[k].stream));
  encoder.cull(recorded.cull);
  encoder.front_is_clockwise(draw.mirrored);
  const UploadedScene::Triangles triangles = uploaded_.triangles(draw);
  encoder.indices(triangles.indices);
  encoder.draw_indexed(static_cast<std::uint32_t>(triangles.count));
}

void Draws::record(gpu::Encoder& encoder, const Records& records) const {
  for (const Recorded& recorded : records)
    record(encoder, recorded);
}

void Draws::shade(gpu::Encoder& encoder, const RecordedRegion& region,
                  const UniformArray& regions) const {
  bind_region(encoder, regions, region.block);
  bind(encoder, region.pipeline, *region.draw);
  encoder.cull(gpu::Cull::back);
  encoder.front_is_clockwise(false);
  encoder.draw(6);
}

void bind_region(gpu::Encoder& encoder, const UniformArray& regions, std::size_t block) {
  encoder.buffer("Region", regions.buffer, regions.offset(block), regions.size);
}

} // namespace gg::frame
