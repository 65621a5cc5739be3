// What a scene asks to be drawn: one draw per primitive of each instance, and how a pass records it.
#pragma once

#include "frame/features.h"
#include "frame/uploaded_scene.h"
#include "gpu/device.h"
#include "tables/device_tables.h"

#include <map>
#include <string>
#include <utility>
#include <vector>

namespace gg::frame {

// How a surface takes part in a frame.
enum class Role {
  opaque,    // hides what is behind it (alpha masks too)
  blended,   // lies over it, by coverage
  refractive // shows it bent: glass
};

struct Draw {
  const scene::Primitive* primitive = nullptr;
  const scene::Material* material = nullptr;
  std::size_t material_index = 0, instance_index = 0;
  Role role = Role::opaque;
  FeatureKey key{};
  scene::Bounds bounds;              // in the world
  double distance = 0.0;             // metres along the view from the eye to the bounds' centre
  std::vector<scene::Index> streams; // one per vertex binding
  struct Map {
    const char* name; // in the shader
    UploadedTexture texture;
  };
  std::vector<Map> maps;
  std::uint32_t index_count = 0;
  bool mirrored = false, both_sides = false;
};

// What a pass does with draws: stages/opaque.vert into one of its fragment stages.
struct DrawPass {
  std::string label; // of the pipelines; passes of the same label are the same pass
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
  // `scene` must outlive this.
  Draws(gpu::Device& device, const UploadedScene& scene, const tables::DeviceTables& tables,
        const FrameFeatures& features, const scene::Camera& camera);

  const std::vector<Draw>& all() const { return draws_; } // in the order of the scene
  // Near to far for opaque surfaces (the depth test then spares hidden shading), far to near for
  // the others ("over" is then right).
  std::vector<const Draw*> of(Role role) const;
  std::size_t triangle_count() const;

  // Compiled at the first call, kept from then on.
  gpu::PipelineRef pipeline(const DrawPass& pass, const Draw& draw);

  // Binds the draw's geometry, instance, material, maps and tables and draws it; the pass has bound
  // Frame, Lights and the environment. `cull` in place of the material's own.
  void record(gpu::Encoder& encoder, const gpu::PipelineRef& pipeline, const Draw& draw) const;
  void record(gpu::Encoder& encoder, const gpu::PipelineRef& pipeline, const Draw& draw,
              gpu::Cull cull) const;

  // Every texture that record() may bind: what a pass has to declare.
  const std::vector<gpu::View>& sampled() const { return sampled_; }

private:
  gpu::Device& device_;
  const UploadedScene& uploaded_;
  const tables::DeviceTables& tables_;
  FrameFeatures features_;
  std::vector<Draw> draws_;
  std::vector<gpu::View> sampled_;
  std::map<std::pair<std::string, FeatureKey>, gpu::PipelineRef> pipelines_;
};

// The tables that stand for a material's lobe.
tables::Model model_of(const scene::Material& material, bool correlated_smith);

} // namespace gg::frame
