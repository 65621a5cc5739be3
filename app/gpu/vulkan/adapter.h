// The physical devices of a machine: what they are, whether they will do, and which is the best.
#pragma once

#include "gpu/device.h"
#include "gpu/vulkan/instance.h"

#include <optional>
#include <string>
#include <vector>

namespace gg::gpu::vulkan {

// What a device can do, in the structures that Vulkan fills.
struct Abilities {
  VkPhysicalDeviceProperties properties{};
  VkPhysicalDeviceDriverProperties driver{};
  VkPhysicalDeviceIDProperties id{};
  std::uint64_t max_allocation = 0, max_buffer = 0; // bytes
  VkPhysicalDeviceFeatures features{};
  VkPhysicalDeviceVulkan12Features features12{};
  VkPhysicalDeviceVulkan13Features features13{};
  std::vector<VkQueueFamilyProperties> queues;
};

struct Adapter {
  VkPhysicalDevice handle = VK_NULL_HANDLE;
  Abilities abilities;
  std::uint32_t queue_family = 0; // draws, computes and copies
  DeviceInfo info;                // index counts the usable devices, best first
  std::vector<std::string> missing;
};

// What keeps a device from being used, in words; empty if nothing does.
std::vector<std::string> missing(const Abilities& abilities);

// The first queue family that draws and computes.
std::optional<std::uint32_t> queue_family(const std::vector<VkQueueFamilyProperties>& queues);

// All of them, usable before unusable, GPUs before software.
std::vector<Adapter> adapters(const Instance& instance);

// The one with that index, or with -1 the first. Throws Error(device) listing what there is.
Adapter choose(const std::vector<Adapter>& adapters, int index);

} // namespace gg::gpu::vulkan
