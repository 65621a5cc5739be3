// The device by OpenGL 4.5.
#pragma once

#include "gpu/names.h"
#include "gpu/opengl/context.h"
#include "gpu/opengl/encoder.h"
#include "gpu/opengl/timers.h"

#include <vector>

namespace gg::gpu::opengl {

class GlDevice final : public Device {
public:
  GlDevice(ContextRef context, DeviceInfo info);

  const DeviceInfo& info() const override { return info_; }
  BufferRef create(const BufferDesc& desc, std::span<const std::byte> contents) override;
  TextureRef create(const TextureDesc& desc) override;
  SamplerRef create(const SamplerDesc& desc) override;
  PipelineRef create(const PipelineDesc& desc) override;
  PipelineRef create(const ComputeDesc& desc) override;
  void expect(std::span<const std::string> stages) override;
  void upload(const TextureRef& texture, int level, int layer,
              std::span<const std::byte> texels) override;
  void upload(const BufferRef& buffer, std::size_t offset,
              std::span<const std::byte> bytes) override;
  void generate_mipmaps(const TextureRef& texture) override;
  std::vector<std::byte> read(const TextureRef& texture, int level, int layer) override;
  std::vector<std::byte> read(const BufferRef& buffer, std::size_t offset,
                              std::size_t bytes) override;
  void run(std::span<const Pass> passes, std::vector<PassTime>* times) override;
  void finish() override;
  std::size_t memory_bytes() const override { return context_->held_bytes; }
  int max_texture_size() const override { return context_->limits().texture_2d; }
  DeviceCounters counters() const override { return context_->counters; }

private:
  void run(const Pass& pass);

  ContextRef context_;
  DeviceInfo info_;
  Names names_;
  GlEncoder encoder_;
  Timers timers_;
  std::vector<SamplerRef> samplers_;
};

} // namespace gg::gpu::opengl
