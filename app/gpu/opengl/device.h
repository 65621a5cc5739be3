// The device by OpenGL 4.5.
#pragma once

#include "gpu/checked_device.h"
#include "gpu/names.h"
#include "gpu/opengl/context.h"
#include "gpu/opengl/encoder.h"
#include "gpu/opengl/timers.h"

#include <vector>

namespace gg::gpu::opengl {

class GlDevice final : public CheckedDevice {
public:
  GlDevice(ContextRef context, DeviceInfo info);

  const DeviceInfo& info() const override { return info_; }
  void run(std::span<const Pass> passes, std::vector<PassTime>* times) override;
  void finish() override;
  std::size_t memory_bytes() const override { return context_->held_bytes; }
  DeviceCounters counters() const override { return context_->counters; }

protected:
  BufferRef make(const BufferDesc& desc, std::span<const std::byte> contents) override;
  TextureRef make(const TextureDesc& desc) override;
  SamplerRef make(const SamplerDesc& desc) override;
  PipelineRef make(const PipelineDesc& desc) override;
  PipelineRef make(const ComputeDesc& desc) override;
  void fill(const TextureRef& texture, int level, int layer,
            std::span<const std::byte> texels) override;
  void fill(const BufferRef& buffer, std::size_t offset, std::span<const std::byte> bytes) override;
  void fill_levels(const TextureRef& texture) override;
  std::vector<std::byte> fetch(const TextureRef& texture, int level, int layer) override;
  std::vector<std::byte> fetch(const BufferRef& buffer, std::size_t offset,
                               std::size_t bytes) override;

private:
  void run(const Pass& pass);

  ContextRef context_;
  DeviceInfo info_;
  Names names_;
  GlEncoder encoder_;
  Timers timers_;
};

} // namespace gg::gpu::opengl
