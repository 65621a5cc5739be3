#include "gpu/vulkan/adapter.h"

#include "gpu/vulkan/result.h"

#include <fmt/format.h>

#include <algorithm>

namespace gg::gpu::vulkan {

namespace {

Abilities abilities_of(const InstanceFunctions& vk, VkPhysicalDevice device) {
  Abilities found;
  found.driver.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_DRIVER_PROPERTIES;
  found.id.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_ID_PROPERTIES;
  VkPhysicalDeviceMaintenance3Properties limits3{
      .sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_MAINTENANCE_3_PROPERTIES};
  VkPhysicalDeviceMaintenance4Properties limits4{
      .sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_MAINTENANCE_4_PROPERTIES};
  VkPhysicalDeviceProperties2 properties{.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2,
                                         .pNext = &found.driver};
  found.driver.pNext = &found.id;
  found.id.pNext = &limits3;
  limits3.pNext = &limits4;
  vk.GetPhysicalDeviceProperties2(device, &properties);
  found.driver.pNext = found.id.pNext = nullptr;
  found.properties = properties.properties;
  found.max_allocation = limits3.maxMemoryAllocationSize;
  found.max_buffer = limits4.maxBufferSize;

  found.features12.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_2_FEATURES;
  found.features13.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_3_FEATURES;
  found.features12.pNext = &found.features13;
  VkPhysicalDeviceFeatures2 features{.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FEATURES_2,
                                     .pNext = &found.features12};
  vk.GetPhysicalDeviceFeatures2(device, &features);
  found.features12.pNext = nullptr;
  found.features = features.features;

  std::uint32_t count = 0;
  vk.GetPhysicalDeviceQueueFamilyProperties2(device, &count, nullptr);
  std::vector<VkQueueFamilyProperties2> families(
      count, {.sType = VK_STRUCTURE_TYPE_QUEUE_FAMILY_PROPERTIES_2});
  vk.GetPhysicalDeviceQueueFamilyProperties2(device, &count, families.data());
  for (const auto& family : families)
    found.queues.push_back(family.queueFamilyProperties);
  return found;
}

// Lower is better.
int rank(VkPhysicalDeviceType type) {
  switch (type) {
  case VK_PHYSICAL_DEVICE_TYPE_DISCRETE_GPU:
    return 0;
  case VK_PHYSICAL_DEVICE_TYPE_INTEGRATED_GPU:
    return 1;
  case VK_PHYSICAL_DEVICE_TYPE_VIRTUAL_GPU:
    return 2;
  case VK_PHYSICAL_DEVICE_TYPE_CPU:
    return 4;
  default:
    return 3;
  }
}

std::string driver_of(const Abilities& abilities) {
  const std::string name = abilities.driver.driverName, info = abilities.driver.driverInfo;
  return name.empty() || info.empty() ? name + info : name + " " + info;
}

} // namespace

std::optional<std::uint32_t> queue_family(const std::vector<VkQueueFamilyProperties>& queues) {
  constexpr VkQueueFlags both = VK_QUEUE_GRAPHICS_BIT | VK_QUEUE_COMPUTE_BIT;
  for (std::uint32_t i = 0; i < queues.size(); ++i)
    if (queues[i].queueCount > 0 && (queues[i].queueFlags & both) == both) return i;
  return std::nullopt;
}

std::vector<std::string> missing(const Abilities& abilities) {
  std::vector<std::string> wants;
  const std::uint32_t version = abilities.properties.apiVersion;
  if (version < VK_API_VERSION_1_3)
    wants.push_back(fmt::format("Vulkan 1.3 (it has {}.{})", VK_API_VERSION_MAJOR(version),
                                VK_API_VERSION_MINOR(version)));
  if (!queue_family(abilities.queues)) wants.push_back("a queue that draws and computes");
  // Vulkan 1.3 promises these; a driver that reports 1.3 without them is not to be trusted.
  if (!abilities.features12.timelineSemaphore) wants.push_back("timeline semaphores");
  if (!abilities.features13.dynamicRendering) wants.push_back("dynamic rendering");
  if (!abilities.features13.synchronization2) wants.push_back("synchronization2");
  return wants;
}

std::vector<Adapter> adapters(const Instance& instance) {
  const InstanceFunctions& vk = instance.functions();
  std::uint32_t count = 0;
  check(vk.EnumeratePhysicalDevices(instance.handle(), &count, nullptr), "listing the devices");
  std::vector<VkPhysicalDevice> handles(count);
  const VkResult result = vk.EnumeratePhysicalDevices(instance.handle(), &count, handles.data());
  if (result != VK_INCOMPLETE) check(result, "listing the devices");
  handles.resize(count);

  std::vector<Adapter> all;
  for (VkPhysicalDevice handle : handles) {
    Adapter adapter{.handle = handle, .abilities = abilities_of(vk, handle)};
    adapter.missing = missing(adapter.abilities);
    adapter.queue_family = queue_family(adapter.abilities.queues).value_or(0);
    adapter.info = {.backend = "vulkan",
                    .surface = "headless",
                    .name = adapter.abilities.properties.deviceName,
                    .driver = driver_of(adapter.abilities),
                    .software =
                        adapter.abilities.properties.deviceType == VK_PHYSICAL_DEVICE_TYPE_CPU};
    all.push_back(std::move(adapter));
  }
  std::stable_sort(all.begin(), all.end(), [](const Adapter& a, const Adapter& b) {
    return std::pair(!a.missing.empty(), rank(a.abilities.properties.deviceType))
           < std::pair(!b.missing.empty(), rank(b.abilities.properties.deviceType));
  });
  for (int i = 0; i < static_cast<int>(all.size()); ++i)
    all[static_cast<std::size_t>(i)].info.index = i;
  return all;
}

Adapter choose(const std::vector<Adapter>& adapters, int index) {
  constexpr auto install = "Install the GPU's driver, or one that needs no GPU (Debian, Ubuntu: "
                           "mesa-vulkan-drivers), or choose --backend opengl";
  if (adapters.empty())
    throw Error(ExitCode::device, "vulkan", "the installed drivers found no device", install);

  std::string usable, unusable;
  for (const Adapter& adapter : adapters)
    if (adapter.missing.empty())
      usable += (usable.empty() ? "" : "; ") + adapter.info.name;
    else
      unusable += fmt::format("{}{} lacks {}", unusable.empty() ? "" : "; ", adapter.info.name,
                              fmt::join(adapter.missing, ", "));
  if (usable.empty())
    throw Error(ExitCode::device, "vulkan", "no device will do: " + unusable,
                "Update the driver, or choose --backend opengl");
  const auto chosen = std::find_if(adapters.begin(), adapters.end(), [&](const Adapter& adapter) {
    return adapter.missing.empty() && adapter.info.index == std::max(index, 0);
  });
  if (chosen == adapters.end())
    throw Error(ExitCode::device, "vulkan", "it has no such device, only: " + usable,
                "Choose --device from what groundglass devices lists");
  return *chosen;
}

} // namespace gg::gpu::vulkan
