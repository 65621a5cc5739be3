// A frame of one scene: which passes it takes, and running them.
#pragma once

#include "frame/backdrop.h"
#include "frame/draws.h"
#include "frame/features.h"
#include "frame/interior.h"
#include "frame/layers.h"
#include "frame/uploaded_scene.h"
#include "gpu/device.h"
#include "image/image.h"
#include "tables/device_tables.h"

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace gg::environment {
struct Stack;
}
namespace gg::frame {

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

  // Draws the frame. With `times`, adds what each pass took, summed over the samples, under its
  // label.
  void draw(std::map<std::string, double>* times = nullptr);
  // One sample of the frame, for callers that show progress; 0 <= i < samples, in order.
  void draw_sample(int i, std::map<std::string, double>* times = nullptr);

  // The frame as drawn: linear radiance, RGBA (a = coverage by meshes or environment).
  image::Image read();

  std::vector<std::string> pass_labels() const; // in the order of one sample
  std::size_t triangle_count() const { return draws_.triangle_count(); } // per sample

private:
  struct Recorded {
    const Draw* draw;
    gpu::PipelineRef pipeline;
    gpu::Cull cull;
  };
  struct GlassLayer {
    std::vector<Recorded> draws;         // in the order in which they are drawn
    std::vector<const Draw*> solids;     // whose insides rays are followed through
    std::vector<const Draw*> foreground; // cut out of the picture behind
    bool refracts = false;               // needs the picture of what is behind it
  };
  tables::DeviceTables wanted_tables() const; // of the models that the scene's materials use
  FrameFeatures features() const;
  void make_targets();
  void make_frame_blocks();
  void make_passes();
  void make_layers();
  Recorded recorded(const DrawPass& pass, const LayerDraw& draw);
  void begin(gpu::Encoder& encoder, int sample) const; // binds what every draw reads
  gpu::Pass opaque_pass(int sample) const;
  gpu::Pass reflective_pass(int sample) const;
  gpu::Pass layer_pass(int sample, std::size_t layer) const;
  std::vector<gpu::View> sampled() const; // every texture that the draws read
  void bind_environment(gpu::Encoder& encoder) const;
  void record_sky(gpu::Encoder& encoder) const;

  gpu::Device& device_;
  FrameDesc desc_;
  UploadedScene uploaded_;
  tables::DeviceTables tables_;
  Draws draws_;
  gpu::TextureRef color_, depth_, average_;
  UniformArray frames_; // one block per sample
  gpu::SamplerRef nearest_;
  gpu::PipelineRef sky_, accumulate_;
  std::vector<Recorded> opaque_;
  std::vector<Recorded> reflective_;  // opaque draws whose reflections show the picture
  std::vector<Recorded> over_opaque_; // blended surfaces with no glass behind them
  std::vector<GlassLayer> layers_;    // the farthest first
  std::optional<Backdrop> backdrop_;
  std::optional<Interior> interior_;
  std::vector<std::vector<gpu::Pass>> passes_; // by sample
};

} // namespace gg::frame
