#include "gpu/vulkan/context.h"

#include <algorithm>
#include <cstring>
#include <limits>
#include <vector>

namespace gg::gpu::vulkan {

VkPhysicalDeviceFeatures optional_features(const VkPhysicalDeviceFeatures& has) {
  VkPhysicalDeviceFeatures on{};
  on.samplerAnisotropy = has.samplerAnisotropy;
  on.imageCubeArray = has.imageCubeArray;
  on.independentBlend = has.independentBlend; // integer targets beside blended ones
  on.vertexPipelineStoresAndAtomics = has.vertexPipelineStoresAndAtomics;
  on.fragmentStoresAndAtomics = has.fragmentStoresAndAtomics;
  on.shaderStorageImageExtendedFormats = has.shaderStorageImageExtendedFormats; // rg16f and kin
  on.shaderStorageImageReadWithoutFormat = has.shaderStorageImageReadWithoutFormat;
  on.shaderStorageImageWriteWithoutFormat = has.shaderStorageImageWriteWithoutFormat;
  return on;
}

namespace {

bool makes_swapchains(const InstanceFunctions& vk, VkPhysicalDevice device) {
  std::uint32_t count = 0;
  vk.EnumerateDeviceExtensionProperties(device, nullptr, &count, nullptr);
  std::vector<VkExtensionProperties> extensions(count);
  vk.EnumerateDeviceExtensionProperties(device, nullptr, &count, extensions.data());
  return std::ranges::any_of(extensions, [](const VkExtensionProperties& extension) {
    return std::strcmp(extension.extensionName, VK_KHR_SWAPCHAIN_EXTENSION_NAME) == 0;
  });
}

} // namespace

Context::Context(const DeviceDesc& desc, std::span<const char* const> windows) {
  instance_ = std::make_unique<Instance>(desc.debug, "libvulkan.so.1", windows);
  adapter_ = choose(adapters(*instance_), desc.device);
  if (!windows.empty()) {
    adapter_.info.surface = "window";
    if (!makes_swapchains(instance_->functions(), adapter_.handle))
      throw Error(ExitCode::device, "window", adapter_.info.name + " does not draw into windows",
                  "Choose another --device (groundglass devices lists them), or --backend opengl.");
  }
  features_ = optional_features(adapter_.abilities.features);

  const float priority = 1.0f;
  const VkDeviceQueueCreateInfo queue{.sType = VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO,
                                      .queueFamilyIndex = adapter_.queue_family,
                                      .queueCount = 1,
                                      .pQueuePriorities = &priority};
  VkPhysicalDeviceVulkan13Features features13{
      .sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_3_FEATURES,
      .synchronization2 = VK_TRUE,
      .dynamicRendering = VK_TRUE};
  const VkPhysicalDeviceVulkan12Features features12{
      .sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_2_FEATURES,
      .pNext = &features13,
      .timelineSemaphore = VK_TRUE};
  const char* const swapchains = VK_KHR_SWAPCHAIN_EXTENSION_NAME;
  const VkDeviceCreateInfo info{.sType = VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO,
                                .pNext = &features12,
                                .queueCreateInfoCount = 1,
                                .pQueueCreateInfos = &queue,
                                .enabledExtensionCount = windows.empty() ? 0u : 1u,
                                .ppEnabledExtensionNames = &swapchains,
                                .pEnabledFeatures = &features_};
  const InstanceFunctions& functions = instance_->functions();
  check(functions.CreateDevice(adapter_.handle, &info, nullptr, &device_), "opening the device");
  try {
    vk_ = Library::functions(functions, device_);
    vk_.GetDeviceQueue(device_, adapter_.queue_family, 0, &queue_);
    name(VK_OBJECT_TYPE_DEVICE, device_, adapter_.info.name);
    name(VK_OBJECT_TYPE_QUEUE, queue_, "queue");

    const VkSemaphoreTypeCreateInfo type{.sType = VK_STRUCTURE_TYPE_SEMAPHORE_TYPE_CREATE_INFO,
                                         .semaphoreType = VK_SEMAPHORE_TYPE_TIMELINE};
    const VkSemaphoreCreateInfo semaphore{.sType = VK_STRUCTURE_TYPE_SEMAPHORE_CREATE_INFO,
                                          .pNext = &type};
    check(vk_.CreateSemaphore(device_, &semaphore, nullptr, &timeline_), "making the timeline");
    name(VK_OBJECT_TYPE_SEMAPHORE, timeline_, "timeline");

    VkPhysicalDeviceMemoryProperties2 memory{
        .sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_MEMORY_PROPERTIES_2};
    functions.GetPhysicalDeviceMemoryProperties2(adapter_.handle, &memory);
    memory_ = std::make_unique<Memory>(vk_, device_, memory.memoryProperties);
  } catch (...) {
    if (timeline_) vk_.DestroySemaphore(device_, timeline_, nullptr);
    if (vk_.DestroyDevice) vk_.DestroyDevice(device_, nullptr);
    throw;
  }
}

Context::~Context() {
  vk_.DeviceWaitIdle(device_); // a lost device is idle
  for (const Retired& retired : retired_)
    retired.destroy();
  memory_.reset();
  vk_.DestroySemaphore(device_, timeline_, nullptr);
  vk_.DestroyDevice(device_, nullptr);
}

VkFormatFeatureFlags Context::features_of(VkFormat format) const {
  VkFormatProperties2 properties{.sType = VK_STRUCTURE_TYPE_FORMAT_PROPERTIES_2};
  instance_->functions().GetPhysicalDeviceFormatProperties2(adapter_.handle, format, &properties);
  return properties.formatProperties.optimalTilingFeatures;
}

void Context::name(VkObjectType type, std::uint64_t handle, const std::string& label) const {
  if (!instance_->has_labels() || label.empty()) return;
  const VkDebugUtilsObjectNameInfoEXT info{.sType =
                                               VK_STRUCTURE_TYPE_DEBUG_UTILS_OBJECT_NAME_INFO_EXT,
                                           .objectType = type,
                                           .objectHandle = handle,
                                           .pObjectName = label.c_str()};
  check(instance_->functions().SetDebugUtilsObjectNameEXT(device_, &info), "naming an object");
}

void Context::begin_label(VkCommandBuffer commands, const std::string& label) const {
  if (!instance_->has_labels()) return;
  const VkDebugUtilsLabelEXT info{.sType = VK_STRUCTURE_TYPE_DEBUG_UTILS_LABEL_EXT,
                                  .pLabelName = label.c_str()};
  instance_->functions().CmdBeginDebugUtilsLabelEXT(commands, &info);
}

void Context::end_label(VkCommandBuffer commands) const {
  if (instance_->has_labels()) instance_->functions().CmdEndDebugUtilsLabelEXT(commands);
}

std::uint64_t Context::completed() {
  std::uint64_t value = 0;
  check(vk_.GetSemaphoreCounterValue(device_, timeline_, &value), "asking how far the device is");
  return value;
}

void Context::wait(std::uint64_t value) {
  const VkSemaphoreWaitInfo info{.sType = VK_STRUCTURE_TYPE_SEMAPHORE_WAIT_INFO,
                                 .semaphoreCount = 1,
                                 .pSemaphores = &timeline_,
                                 .pValues = &value};
  check(vk_.WaitSemaphores(device_, &info, std::numeric_limits<std::uint64_t>::max()),
        "waiting for the device");
}

void Context::retire(std::function<void()> destroy) {
  retired_.push_back({submitted + (recording ? 1 : 0), std::move(destroy)});
}

void Context::collect() {
  if (retired_.empty()) return;
  const std::uint64_t reached = completed();
  while (!retired_.empty() && retired_.front().value <= reached) {
    retired_.front().destroy();
    retired_.pop_front();
  }
}

Allocation Context::take(const VkMemoryRequirements& wanted, MemoryKind kind, bool linear,
                         const std::string& doing) {
  Allocation allocation;
  VkResult result = VK_ERROR_OUT_OF_DEVICE_MEMORY;
  if (wanted.size <= adapter_.abilities.max_allocation)
    result = memory_->take(wanted, kind, linear, allocation);
  if (result != VK_SUCCESS && !retired_.empty()) {
    wait(submitted);
    collect();
    result = memory_->take(wanted, kind, linear, allocation);
  }
  if (result != VK_SUCCESS) throw error_of(result, doing);
  if (counters.allocations != memory_->block_count())
    name(VK_OBJECT_TYPE_DEVICE_MEMORY, allocation.memory,
         "memory block " + std::to_string(memory_->block_count()));
  counters.allocations = memory_->block_count();
  return allocation;
}

Allocation Context::bind_memory(VkBuffer buffer, MemoryKind kind, const std::string& doing) {
  const VkBufferMemoryRequirementsInfo2 of{
      .sType = VK_STRUCTURE_TYPE_BUFFER_MEMORY_REQUIREMENTS_INFO_2, .buffer = buffer};
  VkMemoryRequirements2 wanted{.sType = VK_STRUCTURE_TYPE_MEMORY_REQUIREMENTS_2};
  vk_.GetBufferMemoryRequirements2(device_, &of, &wanted);
  const Allocation allocation = take(wanted.memoryRequirements, kind, true, doing);
  const VkBindBufferMemoryInfo info{.sType = VK_STRUCTURE_TYPE_BIND_BUFFER_MEMORY_INFO,
                                    .buffer = buffer,
                                    .memory = allocation.memory,
                                    .memoryOffset = allocation.offset};
  if (const VkResult result = vk_.BindBufferMemory2(device_, 1, &info); result != VK_SUCCESS) {
    memory_->give(allocation);
    throw error_of(result, doing);
  }
  return allocation;
}

Allocation Context::bind_memory(VkImage image, const std::string& doing) {
  const VkImageMemoryRequirementsInfo2 of{
      .sType = VK_STRUCTURE_TYPE_IMAGE_MEMORY_REQUIREMENTS_INFO_2, .image = image};
  VkMemoryRequirements2 wanted{.sType = VK_STRUCTURE_TYPE_MEMORY_REQUIREMENTS_2};
  vk_.GetImageMemoryRequirements2(device_, &of, &wanted);
  const Allocation allocation = take(wanted.memoryRequirements, MemoryKind::device, false, doing);
  const VkBindImageMemoryInfo info{.sType = VK_STRUCTURE_TYPE_BIND_IMAGE_MEMORY_INFO,
                                   .image = image,
                                   .memory = allocation.memory,
                                   .memoryOffset = allocation.offset};
  if (const VkResult result = vk_.BindImageMemory2(device_, 1, &info); result != VK_SUCCESS) {
    memory_->give(allocation);
    throw error_of(result, doing);
  }
  return allocation;
}

} // namespace gg::gpu::vulkan
