// Buffers, textures and samplers.
#pragma once

#include "gpu/opengl/context.h"
#include "gpu/types.h"

#include <span>
#include <vector>

namespace gg::gpu::opengl {

struct GlBuffer final : Buffer {
  GlBuffer(ContextRef owner, const BufferDesc& what, std::span<const std::byte> contents);
  ~GlBuffer() override;

  ContextRef context;
  GLuint name = 0;
  std::uint64_t serial = 0;
  std::uint64_t written = 0; // the last shader write (Context::writes)
};

struct GlTexture final : Texture {
  GlTexture(ContextRef owner, const TextureDesc& what);
  ~GlTexture() override;

  // A texture or a view of one, as it is bound.
  struct Handle {
    GLuint name = 0;
    std::uint64_t serial = 0;
  };
  // The view as a shader that declares `shape` sees it. Views are made once and kept.
  Handle handle(const View& view, Shape shape);

  Attachment attachment(const View& view) const;
  void upload(int level, int layer, std::span<const std::byte> texels);
  std::vector<std::byte> read(int level, int layer);

  ContextRef context;
  GLuint name = 0;
  std::uint64_t serial = 0;
  std::uint64_t written = 0; // the last shader write (Context::writes)

private:
  struct CachedView {
    Shape shape = Shape::d2;
    int level = 0, level_count = 0, layer = 0, layer_count = 0;
    Handle handle;
    bool operator==(const CachedView& other) const {
      return shape == other.shape && level == other.level && level_count == other.level_count
             && layer == other.layer && layer_count == other.layer_count;
    }
  };
  std::vector<CachedView> views_;
};

struct GlSampler final : Sampler {
  GlSampler(ContextRef owner, const SamplerDesc& what);
  ~GlSampler() override;

  ContextRef context;
  GLuint name = 0;
  std::uint64_t serial = 0;
};

// What the interface's objects are here. Throws Error(internal) naming `what` for null.
GlBuffer& of(const BufferRef& buffer, std::string_view what);
GlTexture& of(const TextureRef& texture, std::string_view what);

} // namespace gg::gpu::opengl
