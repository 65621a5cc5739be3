// Frames of one scene: works out what they need, and carries out their graph.
#pragma once

#include "frame/declare.h"
#include "frame/draws.h"
#include "frame/execution.h"
#include "frame/frame_desc.h"
#include "frame/uploaded_scene.h"
#include "gpu/device.h"
#include "image/image.h"
#include "needs/needs.h"
#include "needs/shapes.h"
#include "tables/device_tables.h"

#include <map>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace gg::frame {

// What may have been worked out before there was a device.
struct Prepared {
  std::optional<needs::Shapes> shapes;        // of the scene
  const scene::CoarseLists* coarse = nullptr; // as use_coarse()
};

class Renderer {
public:
  // Uploads the scene and compiles what it needs; `scene` and the environment must outlive the
  // renderer.
  Renderer(gpu::Device& device, const scene::Scene& scene, const FrameDesc& desc,
           Prepared prepared = {});
  ~Renderer();
  Renderer(const Renderer&) = delete;
  Renderer& operator=(const Renderer&) = delete;

  // Another camera, size, method, environment or number of samples, and the scene's materials as they are by now. What is on the
  // device stays: geometry, images, tables, pipelines, targets of the same size.
  void set(const FrameDesc& desc);
  void materials_changed() { scene_changed(), set(desc_); }
  // Before set(): the scene's instances and lights have been moved, or materials bound other volumes than before.
  void scene_changed() { shapes_.scene_changed(); }
  // The same where vertices have moved too: meshes are uploaded again.
  void geometry_changed() {
    shapes_.geometry_changed();
    uploaded_.forget_geometry();
  }
  // Before set(): meshes may be drawn with fewer triangles where their error is under half a pixel (frame/detail.h); null, as it is
  // at first: they are drawn whole. The lists outlive the renderer or the next call.
  void use_coarse(const scene::CoarseLists* lists) { uploaded_.use_coarse(lists); }
  void forget_pipelines() { draws_.forget(); } // before set(): shaders have changed

  // Draws the frame. With `times`, adds what each pass took, summed over the samples, under its
  // label.
  void draw(std::map<std::string, double>* times = nullptr);
  // One sample of the frame, for callers that show progress; 0 <= i < samples, in order.
  void draw_sample(int i, std::map<std::string, double>* times = nullptr);
  // One pass of it, for callers that have other things to do between: all of them, in order, are draw_sample().
  std::size_t pass_count(int sample) const {
    return passes_[static_cast<std::size_t>(sample)].size();
  }
  void draw_pass(int sample, std::size_t pass, std::map<std::string, double>* times = nullptr);

  // The pipelines that a frame of this description would have to make before it is drawn; other threads compile them meanwhile.
  // make() makes one of them. What is drawn stays as it was set.
  std::vector<gpu::PipelineDesc> missing(const FrameDesc& desc);
  void make(const gpu::PipelineDesc& pipeline) { draws_.pipeline(pipeline); }

  // The frame as drawn: linear radiance, RGBA (a = coverage by meshes or environment).
  image::Image read();
  // The same on the device: RGBA32F. After `drawn` samples of `samples` it holds drawn / samples of the radiance.
  const gpu::TextureRef& picture() const;

  const needs::Needs& needs() const { return needs_; }
  const Graph& graph() const { return graph_; }
  const FrameDesc& desc() const { return desc_; }
  std::vector<std::string> pass_labels() const; // in the order of one sample
  std::size_t triangle_count() const { return needs_.triangle_count(); } // per sample

private:
  void bind(gpu::Encoder& encoder, int sample) const; // what every draw reads
  void upload_tables();
  void run(std::span<const gpu::Pass> passes, std::map<std::string, double>* times);

  gpu::Device& device_;
  const scene::Scene& scene_;
  FrameDesc desc_;
  needs::Shapes shapes_;
  needs::Needs needs_;
  Graph graph_;
  UploadedScene uploaded_;
  tables::DeviceTables tables_;
  // The file that each kind of a model's tables holds.
  std::map<std::pair<const tables::ModelTables*, needs::TableKind>, std::string> table_files_;
  Draws draws_;
  UniformArray frames_, regions_;        // a block per sample, a block per region
  UniformArray shadow_frames_, shadows_; // a block per view of a light, one of all
  Context context_;
  Execution execution_;
  std::vector<std::vector<gpu::Pass>> passes_; // by sample
};

} // namespace gg::frame
