// A frame of one scene: carries out what its needs say, pass by pass.
#pragma once

#include "frame/backdrop.h"
#include "frame/draws.h"
#include "frame/geometry_buffer.h"
#include "frame/interior.h"
#include "frame/uploaded_scene.h"
#include "gpu/device.h"
#include "image/image.h"
#include "needs/needs.h"
#include "tables/device_tables.h"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace gg::environment {
struct Stack;
}
namespace gg::frame {

using needs::Method;

// The light from all around. `stack` null: there is none.
struct EnvironmentView {
  const environment::Stack* stack = nullptr;
  float rotation = 0.0f;  // radians about +Y, counter-clockwise seen from above
  float intensity = 1.0f; // factor on its radiance
};

struct FrameDesc {
  int width = 1280, height = 720;
  int samples =
      16; // sub-pixel frames that are averaged: antialiasing with a box filter of one pixel
  scene::Camera camera;
  EnvironmentView environment;
  Method method = Method::lobes1;
  bool correlated_smith = false, multiple_scattering = false;
};

class Renderer {
public:
  // Uploads the scene and compiles what it needs; `scene` and the environment must outlive the
  // renderer.
  Renderer(gpu::Device& device, const scene::Scene& scene, const FrameDesc& desc);
  ~Renderer();
  Renderer(const Renderer&) = delete;
  Renderer& operator=(const Renderer&) = delete;

  // Draws the frame. With `times`, adds what each pass took, summed over the samples, under its
  // label.
  void draw(std::map<std::string, double>* times = nullptr);
  // One sample of the frame, for callers that show progress; 0 <= i < samples, in order.
  void draw_sample(int i, std::map<std::string, double>* times = nullptr);

  // The frame as drawn: linear radiance, RGBA (a = coverage by meshes or environment).
  image::Image read();

  const needs::Needs& needs() const { return needs_; }
  std::vector<std::string> pass_labels() const; // in the order of one sample
  std::size_t triangle_count() const { return needs_.triangle_count(); } // per sample

private:
  struct Recorded {
    const needs::Draw* draw;
    gpu::PipelineRef pipeline;
    gpu::Cull cull;
  };
  using Records = std::vector<Recorded>;
  struct RecordedRegion {
    Records first; // its draws, before it is shaded: into the depth or the geometry buffer
    const needs::Draw* draw;
    gpu::PipelineRef pipeline;
    std::size_t block; // of regions_
  };
  using RecordedRegions = std::vector<RecordedRegion>;
  void make_targets();
  void make_frame_blocks();
  void make_records();
  void make_opaque_regions(std::vector<uniforms::RegionData>& regions);
  void make_passes();
  Recorded recorded(const DrawPass& pass, const needs::LayerDraw& draw);
  void begin(gpu::Encoder& encoder, int sample) const; // binds what every draw reads
  void record(gpu::Encoder& encoder, const Records& records) const;
  void bind_region(gpu::Encoder& encoder, std::size_t block) const;
  void shade(gpu::Encoder& encoder, const RecordedRegion& region) const;
  gpu::Pass made(const needs::Pass& pass, int sample);
  gpu::Pass geometry_pass(int sample) const;
  gpu::Pass opaque_pass(int sample) const;
  gpu::Pass material_depth_pass() const;
  gpu::Pass deferred_pass(int sample) const;
  gpu::Pass over_opaque_pass(int sample) const;
  gpu::Pass reflective_pass(const needs::Pass& pass, int sample) const;
  gpu::Pass deferred_reflective_pass(const needs::Pass& pass, int sample) const;
  gpu::Pass interior_pass(const needs::Pass& pass, int sample);
  gpu::Pass layer_pass(const needs::Pass& pass, int sample) const;
  gpu::Pass accumulate_pass(int sample) const;
  std::vector<gpu::View> sampled() const; // every texture that the draws read
  void bind_environment(gpu::Encoder& encoder) const;

  gpu::Device& device_;
  FrameDesc desc_;
  needs::Needs needs_;
  UploadedScene uploaded_;
  tables::DeviceTables tables_;
  Draws draws_;
  gpu::TextureRef color_, depth_, average_;
  UniformArray frames_; // one block per sample
  gpu::SamplerRef nearest_;
  gpu::PipelineRef sky_, accumulate_;
  Records opaque_, over_opaque_, reflective_;
  std::vector<Records> layers_; // in the order in which they are drawn
  UniformArray regions_;        // of the opaque surfaces and of all layers
  RecordedRegions opaque_regions_, reflective_regions_;
  std::size_t all_opaque_regions_ = 0; // where they are together, in regions_
  std::vector<RecordedRegions> layer_regions_;
  std::optional<Backdrop> backdrop_;
  std::optional<Interior> interior_;
  std::optional<GeometryBuffer> geometry_;
  std::vector<std::vector<gpu::Pass>> passes_; // by sample
};

} // namespace gg::frame
