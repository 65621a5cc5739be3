// The device by Vulkan 1.3.
#pragma once

#include "gpu/checks.h"
#include "gpu/names.h"
#include "gpu/vulkan/barriers.h"
#include "gpu/vulkan/commands.h"
#include "gpu/vulkan/context.h"
#include "gpu/vulkan/encoder.h"
#include "gpu/vulkan/pipeline.h"
#include "gpu/vulkan/pipeline_cache.h"
#include "gpu/vulkan/timers.h"
#include "gpu/vulkan/transfers.h"

#include <memory>
#include <vector>

namespace gg::gpu::vulkan {

class VulkanDevice final : public Device {
public:
  explicit VulkanDevice(std::shared_ptr<Context> context);
  ~VulkanDevice() override; // waits for what is being done

  const DeviceInfo& info() const override { return context_->adapter().info; }
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
  int max_texture_size() const override { return limits_.texture_2d; }
  DeviceCounters counters() const override { return context_->counters; }

private:
  void order(VkCommandBuffer commands, const Pass& pass); // behind what it depends on
  void record(VkCommandBuffer commands, const Pass& pass);
  PipelineKit kit() { return {context_, layouts_, cache_, names_}; }

  std::shared_ptr<Context> context_;
  Limits limits_;
  Names names_;
  SetLayouts layouts_;
  PipelineCache cache_;
  Commands commands_;
  Transfers transfers_;
  Barriers barriers_;
  SetCache sets_;
  PassEncoder encoder_;
  Timers timers_;
  std::vector<SamplerRef> samplers_;
};

} // namespace gg::gpu::vulkan
