// How a pass records draws: a pipeline per pass and features, kept once compiled.
#pragma once

#include "frame/uniform_array.h"
#include "frame/uploaded_scene.h"
#include "gpu/device.h"
#include "needs/needs.h"
#include "tables/device_tables.h"

#include <functional>
#include <map>
#include <string>
#include <vector>

namespace gg::frame {

// What a pass does with draws: stages/opaque.vert into one of its fragment stages, or stages/region.vert, which takes no mesh.
struct DrawPass {
  std::string label; // of the pipelines
  bool by_region = false;
  std::string fragment;
  std::vector<gpu::Format> colors;
  gpu::Format depth = gpu::Format::depth32f;
  bool depth_write = true;
  gpu::Compare depth_compare = gpu::Compare::greater_equal; // reversed depth: nearer is larger
  gpu::Blend blend = gpu::Blend::none;
  std::vector<gpu::Constant> constants; // besides those of the features
};

// A draw, ready to be recorded.
struct Recorded {
  const needs::Draw* draw;
  gpu::PipelineRef pipeline;
  gpu::Cull cull;
};
using Records = std::vector<Recorded>;

// What is shaded by region: the block that says where.
struct RecordedRegion {
  const needs::Draw* draw;
  gpu::PipelineRef pipeline;
  std::size_t block;
};

class Draws {
public:
  Draws(gpu::Device& device, const UploadedScene& scene, const tables::DeviceTables& tables);

  // While `what` runs pipelines are not made, only told to the device, which compiles them on all cores; those it is given are
  // null.
  void expect(const std::function<void()>& what);
  // The same, and returns them.
  std::vector<gpu::PipelineDesc> missing(const std::function<void()>& what);

  // Compiled at the first call, kept from then on or until all are forgotten.
  void forget() { pipelines_.clear(); }
  gpu::PipelineRef pipeline(const gpu::PipelineDesc& desc);
  gpu::PipelineRef pipeline(const DrawPass& pass, const needs::Draw& draw);
  Recorded recorded(const DrawPass& pass, const needs::LayerDraw& draw);

  // Leaves the depth of blended surfaces where their alpha is a half or more, and no colour: rays through the glass before
  // them meet what is mostly there. Of those of `draws` that have such places.
  Records covers(const std::vector<needs::LayerDraw>& draws);

  // Binds the draw's geometry, instance, material, textures and tables and draws it; the pass has bound Frame, Lights and the
  // environment.
  void record(gpu::Encoder& encoder, const Recorded& recorded) const;
  void record(gpu::Encoder& encoder, const Records& records) const;

  // The same without geometry: two triangles that cover the region.
  void shade(gpu::Encoder& encoder, const RecordedRegion& region,
             const UniformArray& regions) const;

  // Every texture that these may bind: what a pass has to declare.
  std::vector<gpu::View> sampled() const;

private:
  void bind(gpu::Encoder& encoder, const gpu::PipelineRef& pipeline, const needs::Draw& draw) const;

  gpu::Device& device_;
  const UploadedScene& uploaded_;
  const tables::DeviceTables& tables_;
  std::map<std::string, gpu::PipelineRef> pipelines_;
  std::vector<gpu::PipelineDesc> expected_;
  bool expecting_ = false;
};

// Binds the block that says where a region is.
void bind_region(gpu::Encoder& encoder, const UniformArray& regions, std::size_t block);

} // namespace gg::frame
