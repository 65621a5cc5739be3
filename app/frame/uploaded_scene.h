// A scene on the device: every stream, index list and image once, whoever shares it.
#pragma once

#include "frame/blocks.h"
#include "frame/uniform_array.h"
#include "gpu/device.h"
#include "scene/scene.h"

#include <vector>

namespace gg::frame {

// A texture with the sampler that glTF gave it.
struct UploadedTexture {
  gpu::View view;
  gpu::SamplerRef sampler;
};

class UploadedScene {
public:
  UploadedScene(gpu::Device& device, const scene::Scene& scene);

  const scene::Scene& scene() const { return scene_; }
  const gpu::BufferRef& stream(scene::Index i) const {
    return streams_[static_cast<std::size_t>(i)];
  }
  const gpu::BufferRef& indices(scene::Index i) const {
    return indices_[static_cast<std::size_t>(i)];
  }
  const UniformArray& materials() const { return materials_; }
  const UniformArray& instances() const { return instances_; }
  const gpu::BufferRef& lights() const { return lights_; } // one unused light if there are none
  UploadedTexture texture(scene::Index texture, bool srgb) const;
  const UploadedTexture& white() const { return white_; } // for maps that a material lacks

private:
  void upload_textures(gpu::Device& device);

  const scene::Scene& scene_;
  std::vector<gpu::BufferRef> streams_, indices_;
  UniformArray materials_, instances_;
  gpu::BufferRef lights_;
  struct Image {
    gpu::TextureRef srgb, linear; // what materials read it as; null if nothing does
  };
  std::vector<Image> images_;
  std::vector<gpu::SamplerRef> samplers_; // by glTF texture
  UploadedTexture white_;
};

} // namespace gg::frame
