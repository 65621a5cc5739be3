// The device by Vulkan 1.3.
#pragma once

#include "gpu/checked_device.h"
#include "gpu/names.h"
#include "gpu/vulkan/barriers.h"
#include "gpu/vulkan/commands.h"
#include "gpu/vulkan/context.h"
#include "gpu/vulkan/encoder.h"
#include "gpu/vulkan/pipeline.h"
#include "gpu/vulkan/pipeline_cache.h"
#include "gpu/vulkan/timers.h"
#include "gpu/vulkan/transfers.h"

#include <functional>
#include <memory>
#include <vector>

namespace gg::gpu::vulkan {

class VulkanDevice final : public CheckedDevice {
public:
  explicit VulkanDevice(std::shared_ptr<Context> context);
  ~VulkanDevice() override; // waits for what is being done

  const DeviceInfo& info() const override { return context_->adapter().info; }
  void run(std::span<const Pass> passes, std::vector<PassTime>* times) override;
  void finish() override;
  // Records what a window adds behind all passes, and submits it.
  void submit(const std::function<void(VkCommandBuffer, Barriers&)>& record,
              const Around& around = {});
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
  void order(VkCommandBuffer commands, const Pass& pass); // behind what it depends on
  void record(VkCommandBuffer commands, const Pass& pass);
  PipelineKit kit() { return {context_, layouts_, cache_, names_}; }

  std::shared_ptr<Context> context_;
  Names names_;
  SetLayouts layouts_;
  PipelineCache cache_;
  Commands commands_;
  Transfers transfers_;
  Barriers barriers_;
  SetCache sets_;
  PassEncoder encoder_;
  Timers timers_;
};

} // namespace gg::gpu::vulkan
