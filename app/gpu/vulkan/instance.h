// The instance: the loader, the validation layer and its messages, the debug labels.
#pragma once

#include "gpu/vulkan/api.h"

#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace gg::gpu::vulkan {

class Instance {
public:
  // With `debug`, the Khronos validation layer is turned on (core and synchronization validation);
  // a note says so if it is not installed. With `windows`, the extensions that windows of the display need. Throws Error(device)
  // without a loader or a driver.
  explicit Instance(bool debug, const std::string& loader = "libvulkan.so.1",
                    std::span<const char* const> windows = {});
  ~Instance();
  Instance(const Instance&) = delete;
  Instance& operator=(const Instance&) = delete;

  VkInstance handle() const { return handle_; }
  const InstanceFunctions& functions() const { return functions_; }
  bool has_labels() const { return labels_; }
  bool is_validated() const { return validated_; }

  // Throws Error(device) with the first message of the validation layer since the last call, if
  // there is one.
  void check_messages();

private:
  static VKAPI_ATTR VkBool32 VKAPI_CALL hear(VkDebugUtilsMessageSeverityFlagBitsEXT severity,
                                             VkDebugUtilsMessageTypeFlagsEXT types,
                                             const VkDebugUtilsMessengerCallbackDataEXT* data,
                                             void* user);
  std::optional<std::string> take_message();

  Library library_;
  VkInstance handle_ = VK_NULL_HANDLE;
  InstanceFunctions functions_;
  VkDebugUtilsMessengerEXT messenger_ = VK_NULL_HANDLE;
  bool labels_ = false, validated_ = false;
  std::mutex mutex_; // a driver may validate on threads of its own
  std::vector<std::string> messages_;
};

} // namespace gg::gpu::vulkan
