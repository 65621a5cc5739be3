// How a pass records what is drawn: a pipeline per pass and features, kept once compiled.
#pragma once

#include "frame/uploaded_scene.h"
#include "gpu/device.h"
#include "needs/needs.h"
#include "tables/device_tables.h"

#include <map>
#include <string>
#include <utility>
#include <vector>

namespace gg::frame {

// What a pass does with draws: stages/opaque.vert into one of its fragment stages, or stages/region.vert, which takes no mesh.
struct DrawPass {
  std::string label; // of the pipelines; passes of the same label are the same pass
  bool by_region = false;
  std::string fragment;
  std::vector<gpu::Format> colors;
  gpu::Format depth = gpu::Format::depth32f;
  bool depth_write = true;
  gpu::Compare depth_compare = gpu::Compare::greater_equal; // reversed depth: nearer is larger
  gpu::Blend blend = gpu::Blend::none;
  std::vector<gpu::Constant> constants; // besides those of the features
};

class Draws {
public:
  Draws(gpu::Device& device, const UploadedScene& scene, const tables::DeviceTables& tables);

  // Compiled at the first call, kept from then on.
  gpu::PipelineRef pipeline(const DrawPass& pass, const needs::Draw& draw);

  // Binds the draw's geometry, instance, material, maps and tables and draws it; the pass has bound
  // Frame, Lights and the environment. `cull` in place of the material's own.
  void record(gpu::Encoder& encoder, const gpu::PipelineRef& pipeline,
              const needs::Draw& draw) const;
  void record(gpu::Encoder& encoder, const gpu::PipelineRef& pipeline, const needs::Draw& draw,
              gpu::Cull cull) const;

  // The same without geometry: two triangles that cover what Region, bound by the caller, says.
  void record_region(gpu::Encoder& encoder, const gpu::PipelineRef& pipeline,
                     const needs::Draw& draw) const;

  // Every texture that record() may bind: what a pass has to declare.
  const std::vector<gpu::View>& sampled() const { return sampled_; }

private:
  void bind(gpu::Encoder& encoder, const gpu::PipelineRef& pipeline, const needs::Draw& draw) const;

  gpu::Device& device_;
  const UploadedScene& uploaded_;
  const tables::DeviceTables& tables_;
  std::vector<gpu::View> sampled_;
  std::map<std::pair<std::string, needs::FeatureKey>, gpu::PipelineRef> pipelines_;
};

} // namespace gg::frame
