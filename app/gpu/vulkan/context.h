// What every object of this backend shares and keeps alive: the logical device, its memory, and the
// objects that wait for the device to stop using them.
#pragma once

#include "gpu/device.h"
#include "gpu/vulkan/adapter.h"
#include "gpu/vulkan/instance.h"
#include "gpu/vulkan/memory.h"
#include "gpu/vulkan/result.h"

#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>

namespace gg::gpu::vulkan {

// Features beyond the required ones, on where the device has them.
VkPhysicalDeviceFeatures optional_features(const VkPhysicalDeviceFeatures& has);

class Context {
public:
  // With `windows`, what Instance needs for them: it can make swapchains then. Throws Error(device).
  explicit Context(const DeviceDesc& desc, std::span<const char* const> windows = {});
  ~Context(); // waits for the device
  Context(const Context&) = delete;
  Context& operator=(const Context&) = delete;

  const DeviceFunctions& vk() const { return vk_; }
  VkDevice device() const { return device_; }
  VkQueue queue() const { return queue_; }
  const Adapter& adapter() const { return adapter_; }
  const VkPhysicalDeviceLimits& limits() const { return adapter_.abilities.properties.limits; }
  const VkPhysicalDeviceFeatures& features() const { return features_; }
  Instance& instance() const { return *instance_; }
  Memory& memory() { return *memory_; }
  VkFormatFeatureFlags features_of(VkFormat format) const; // of optimally tiled images

  // Names an object for debuggers and validation messages.
  template <typename Handle>
  void name(VkObjectType type, Handle handle, const std::string& label) const {
    name(type, number_of(handle), label);
  }
  void name(VkObjectType type, std::uint64_t handle, const std::string& label) const;
  void begin_label(VkCommandBuffer commands, const std::string& label) const;
  void end_label(VkCommandBuffer commands) const;

  // The timeline: each submission signals the next value.
  VkSemaphore timeline() const { return timeline_; }
  std::uint64_t submitted = 0; // signalled by the last submission
  bool recording = false;      // commands are being recorded for the submission after it
  std::uint64_t completed();   // reached by the device; throws Error(device)
  void wait(std::uint64_t value);

  // Calls `destroy` when the device is done with everything recorded so far.
  void retire(std::function<void()> destroy);
  void collect(); // calls those whose time has come

  // Memory for a buffer or an image, bound to it. On failure what waits to be destroyed is, after
  // waiting for the device, and it is tried once more. Throws Error(device) saying it was `doing`.
  Allocation bind_memory(VkBuffer buffer, MemoryKind kind, const std::string& doing);
  Allocation bind_memory(VkImage image, const std::string& doing);

  // Tells objects apart for ever, where Vulkan's handles are used again after their object is gone.
  std::uint64_t next_serial() { return ++serial_; }

  DeviceCounters counters;
  std::uint64_t held_bytes = 0; // by buffers and textures that are alive

private:
  Allocation take(const VkMemoryRequirements& wanted, MemoryKind kind, bool linear,
                  const std::string& doing);

  std::unique_ptr<Instance> instance_;
  Adapter adapter_;
  VkPhysicalDeviceFeatures features_{};
  VkDevice device_ = VK_NULL_HANDLE;
  DeviceFunctions vk_;
  VkQueue queue_ = VK_NULL_HANDLE;
  VkSemaphore timeline_ = VK_NULL_HANDLE;
  std::unique_ptr<Memory> memory_;
  std::uint64_t serial_ = 0;
  struct Retired {
    std::uint64_t value = 0;
    std::function<void()> destroy;
  };
  std::deque<Retired> retired_; // by value
};

} // namespace gg::gpu::vulkan
