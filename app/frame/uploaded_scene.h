// A scene on the device: every stream, index list and image that its frame reads, once each.
#pragma once

#include "frame/neighbour_blocks.h"
#include "frame/uniform_array.h"
#include "gpu/device.h"
#include "needs/needs.h"
#include "scene/coarse.h"
#include "scene/scene.h"
#include "uniforms/blocks.h"

#include <map>
#include <utility>
#include <vector>

namespace gg::frame {

// A texture with the sampler that glTF gave it.
struct UploadedTexture {
  gpu::View view;
  gpu::SamplerRef sampler;
};

class UploadedScene {
public:
  explicit UploadedScene(gpu::Device& device) : device_(device) {}

  // Uploads what is not there yet; `needs` must outlive this or the next call.
  void set(const needs::Needs& needs);

  void forget_geometry() {
    streams_.clear(), indices_.clear(), coarse_indices_.clear();
  } // before set(): meshes have changed
  // Before set(): lists that may stand for others, which outlive this or the next call; null: none do.
  void use_coarse(const scene::CoarseLists* lists) { coarse_ = lists; }

  const needs::Needs& needs() const { return *needs_; }
  // Of what the needs list.
  const gpu::BufferRef& stream(scene::Index i) const { return streams_.at(i); }
  struct Triangles {
    const gpu::BufferRef& indices;
    std::size_t count = 0; // of indices
  };
  Triangles triangles(const needs::Draw& draw) const;
  UploadedTexture texture(const needs::Map& map) const;
  std::vector<gpu::View> sampled() const; // all images
  const UniformArray& materials() const { return materials_; }
  const UniformArray& instances() const { return instances_; }
  const UniformArray& neighbours() const { return neighbours_; } // by neighbour_block()
  std::size_t neighbour_block(const needs::Draw& draw) const { return neighbour_blocks_.at(&draw); }
  const gpu::BufferRef& lights() const { return lights_; } // one unused light if there are none

private:
  void upload_geometry();
  void upload_blocks();
  void upload_textures();

  gpu::Device& device_;
  const needs::Needs* needs_ = nullptr;
  std::map<scene::Index, gpu::BufferRef> streams_, indices_;
  std::map<const scene::CoarseList*, gpu::BufferRef> coarse_indices_;
  const scene::CoarseLists* coarse_ = nullptr;
  std::map<const needs::Draw*, const scene::CoarseList*> coarsely_drawn_;
  UniformArray materials_, instances_, neighbours_;
  std::map<const needs::Draw*, std::size_t> neighbour_blocks_; // of draws that have neighbours
  ImageMeans image_means_;
  gpu::BufferRef lights_;
  std::map<std::pair<scene::Index, bool>, gpu::TextureRef> images_; // by index, and whether sRGB
  std::map<scene::Index, gpu::SamplerRef> samplers_;                // by glTF texture
};

} // namespace gg::frame
