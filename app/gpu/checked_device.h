// The part of a device that is the same for every backend: requests are checked before any driver sees them,
// and equal samplers are one object. Implementation of app/gpu.
#pragma once

#include "gpu/checks.h"
#include "gpu/device.h"

#include <vector>

namespace gg::gpu {

class CheckedDevice : public Device {
public:
  BufferRef create(const BufferDesc& desc, std::span<const std::byte> contents) final;
  TextureRef create(const TextureDesc& desc) final;
  SamplerRef create(const SamplerDesc& desc) final;
  PipelineRef create(const PipelineDesc& desc) final;
  PipelineRef create(const ComputeDesc& desc) final;
  void expect(std::span<const PipelineDesc> pipelines) final;
  void expect(std::span<const ComputeDesc> pipelines) final;
  void upload(const TextureRef& texture, int level, int layer,
              std::span<const std::byte> texels) final;
  void upload(const BufferRef& buffer, std::size_t offset, std::span<const std::byte> bytes) final;
  void generate_mipmaps(const TextureRef& texture) final;
  std::vector<std::byte> read(const TextureRef& texture, int level, int layer) final;
  std::vector<std::byte> read(const BufferRef& buffer, std::size_t offset, std::size_t bytes) final;
  int max_texture_size() const final { return limits_.texture_2d; }

protected:
  CheckedDevice(Backend backend, const Limits& limits) : backend_(backend), limits_(limits) {}
  const Limits& limits() const { return limits_; }
  void forget_samplers() { samplers_.clear(); }

  // As the functions of Device that they stand behind; what they are given has been checked.
  virtual BufferRef make(const BufferDesc& desc, std::span<const std::byte> contents) = 0;
  virtual TextureRef make(const TextureDesc& desc) = 0;
  virtual SamplerRef make(const SamplerDesc& desc) = 0;
  virtual PipelineRef make(const PipelineDesc& desc) = 0;
  virtual PipelineRef make(const ComputeDesc& desc) = 0;
  virtual void fill(const TextureRef& texture, int level, int layer,
                    std::span<const std::byte> texels) = 0;
  virtual void fill(const BufferRef& buffer, std::size_t offset,
                    std::span<const std::byte> bytes) = 0; // at least one
  virtual void fill_levels(const TextureRef& texture) = 0;
  virtual std::vector<std::byte> fetch(const TextureRef& texture, int level, int layer) = 0;
  virtual std::vector<std::byte> fetch(const BufferRef& buffer, std::size_t offset,
                                       std::size_t bytes) = 0; // at least one

private:
  Backend backend_;
  Limits limits_;
  std::vector<SamplerRef> samplers_;
};

} // namespace gg::gpu
