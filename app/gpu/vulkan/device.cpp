#include "gpu/vulkan/device.h"

#include "core/clock.h"
#include "gpu/backends.h"
#include "gpu/vulkan/formats.h"

#include <algorithm>

namespace gg::gpu::vulkan {

namespace {

Limits limits_of(const VkPhysicalDeviceLimits& limits) {
  const auto number = [](std::uint32_t limit) { // every limit fits an int
    return static_cast<int>(std::min(limit, 1u << 30));
  };
  return {.texture_2d = number(limits.maxImageDimension2D),
          .texture_3d = number(limits.maxImageDimension3D),
          .texture_cube = number(limits.maxImageDimensionCube),
          .array_layers = number(limits.maxImageArrayLayers),
          .uniform_bytes = limits.maxUniformBufferRange,
          .storage_bytes = limits.maxStorageBufferRange,
          .groups =
              std::min({limits.maxComputeWorkGroupCount[0], limits.maxComputeWorkGroupCount[1],
                        limits.maxComputeWorkGroupCount[2]}),
          .attachments = number(limits.maxColorAttachments)};
}

} // namespace

VulkanDevice::VulkanDevice(std::shared_ptr<Context> context)
    : CheckedDevice(Backend::vulkan, limits_of(context->limits())), context_(std::move(context)),
      layouts_(*context_), cache_(*context_), commands_(*context_),
      transfers_(*context_, commands_), barriers_(*context_), sets_(*context_),
      encoder_(*context_, sets_, names_, limits()), timers_(*context_) {}

VulkanDevice::~VulkanDevice() {
  forget_samplers();
  context_->vk().DeviceWaitIdle(context_->device());
}

BufferRef VulkanDevice::make(const BufferDesc& desc, std::span<const std::byte> contents) {
  auto buffer = std::make_shared<GpuBuffer>(context_, desc);
  if (contents.size() < desc.bytes) transfers_.clear(*buffer);
  transfers_.upload(*buffer, 0, contents);
  context_->instance().check_messages();
  return buffer;
}

TextureRef VulkanDevice::make(const TextureDesc& desc) {
  auto texture = std::make_shared<GpuTexture>(context_, desc);
  transfers_.settle_later(texture);
  context_->instance().check_messages();
  return texture;
}

SamplerRef VulkanDevice::make(const SamplerDesc& desc) {
  return std::make_shared<GpuSampler>(context_, desc);
}

PipelineRef VulkanDevice::make(const PipelineDesc& desc) {
  auto pipeline = std::make_shared<GpuPipeline>(kit(), desc);
  context_->instance().check_messages();
  return pipeline;
}

PipelineRef VulkanDevice::make(const ComputeDesc& desc) {
  auto pipeline = std::make_shared<GpuPipeline>(kit(), desc);
  context_->instance().check_messages();
  return pipeline;
}

void VulkanDevice::fill(const TextureRef& texture, int level, int layer,
                        std::span<const std::byte> texels) {
  transfers_.upload(std::static_pointer_cast<GpuTexture>(texture), level, layer, texels);
  context_->instance().check_messages();
}

void VulkanDevice::fill(const BufferRef& buffer, std::size_t offset,
                        std::span<const std::byte> bytes) {
  transfers_.upload(of(buffer), offset, bytes);
  context_->instance().check_messages();
}

void VulkanDevice::fill_levels(const TextureRef& texture) {
  transfers_.generate_mipmaps(std::static_pointer_cast<GpuTexture>(texture));
  context_->instance().check_messages();
}

std::vector<std::byte> VulkanDevice::fetch(const TextureRef& texture, int level, int layer) {
  auto texels = transfers_.read(std::static_pointer_cast<GpuTexture>(texture), level, layer);
  context_->instance().check_messages();
  return texels;
}

std::vector<std::byte> VulkanDevice::fetch(const BufferRef& buffer, std::size_t offset,
                                           std::size_t bytes) {
  auto read = transfers_.read(of(buffer), offset, bytes);
  context_->instance().check_messages();
  return read;
}

void VulkanDevice::order(VkCommandBuffer commands, const Pass& pass) {
  const bool draws = !pass.colors.empty() || pass.depth;
  const VkPipelineStageFlags2 stages = draws ? drawing_stages : computing_stages;
  for (const View& view : pass.reads)
    barriers_.add(commands, of(view.texture), of(view.texture).range_of(view), sampled_by(stages));
  for (const BufferRef& buffer : pass.reads_buffers)
    barriers_.add(of(buffer), buffer_read(draws));
  // On their own, because what is read may be written as well.
  barriers_.issue(commands);

  for (const View& view : pass.storage)
    barriers_.add(commands, of(view.texture), of(view.texture).range_of(view), stored_by(stages));
  for (const BufferRef& buffer : pass.writes_buffers)
    barriers_.add(of(buffer), buffer_written(draws));
  for (const ColorTarget& target : pass.colors)
    barriers_.add(commands, of(target.view.texture), of(target.view.texture).range_of(target.view),
                  color_target(target.clear.has_value()));
  if (pass.depth)
    barriers_.add(commands, of(pass.depth->view.texture),
                  of(pass.depth->view.texture).range_of(pass.depth->view),
                  depth_target(pass.depth->clear.has_value()));
  barriers_.issue(commands);
}

void VulkanDevice::record(VkCommandBuffer commands, const Pass& pass) {
  context_->begin_label(commands, pass.label);
  order(commands, pass);
  // A pass that fails while recording leaves a command buffer that can be submitted: what was
  // recorded before stays in step with what the tracker believes.
  struct End {
    VulkanDevice& device;
    VkCommandBuffer commands;
    ~End() {
      device.encoder_.end();
      device.context_->end_label(commands);
    }
  } const end{*this, commands};
  encoder_.begin(commands, pass);
  pass.record(encoder_);
  ++context_->counters.passes;
}

void VulkanDevice::run(std::span<const Pass> passes, std::vector<PassTime>* times) {
  const auto start = Clock::now();
  const double waited = commands_.waited_ms;
  for (const Pass& pass : passes)
    gpu::check(pass, limits());

  const VkCommandBuffer commands = commands_.open();
  transfers_.settle();
  if (times) timers_.restart(commands, 2 * static_cast<std::uint32_t>(passes.size()));
  for (const Pass& pass : passes) {
    if (times) timers_.stamp(commands);
    record(commands, pass);
    if (times) timers_.stamp(commands);
  }
  commands_.submit();
  context_->counters.record_ms += ms_since(start) - (commands_.waited_ms - waited);
  if (times && !passes.empty()) {
    commands_.finish();
    timers_.collect(passes, *times);
  }
  context_->instance().check_messages();
}

void VulkanDevice::finish() {
  transfers_.settle();
  commands_.finish();
  context_->instance().check_messages();
}

void VulkanDevice::submit(const std::function<void(VkCommandBuffer, Barriers&)>& record,
                          const Around& around) {
  const VkCommandBuffer commands = commands_.open();
  transfers_.settle();
  record(commands, barriers_);
  commands_.submit(around);
  context_->instance().check_messages();
}

std::unique_ptr<Device> create_device(const DeviceDesc& desc) {
  if (desc.surface != Surface::automatic)
    throw Error(ExitCode::usage, "--surface", "Vulkan draws without a surface",
                "Leave --surface out, or choose --backend opengl");
  return std::make_unique<VulkanDevice>(std::make_shared<Context>(desc));
}

std::vector<DeviceInfo> list_devices() {
  std::vector<DeviceInfo> usable;
  try {
    for (const Adapter& adapter : adapters(Instance(false)))
      if (adapter.missing.empty()) usable.push_back(adapter.info);
  } catch (const Error&) {
    // No loader or no driver: nothing to list.
  }
  return usable;
}

} // namespace gg::gpu::vulkan
