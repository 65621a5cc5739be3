#include "gpu/vulkan/api.h"

#include "core/error.h"

#include <dlfcn.h>

namespace gg::gpu::vulkan {

namespace {

constexpr auto broken_installation =
    "Reinstall the Vulkan loader (Debian, Ubuntu: libvulkan1) and the graphics driver, or choose "
    "--backend opengl";

template <typename Function>
void require(Function& to, PFN_vkVoidFunction from, const char* name, const char* whose) {
  if (!from)
    throw Error(ExitCode::device, "vulkan",
                std::string(whose) + " does not have the entry point vk" + name,
                broken_installation);
  to = reinterpret_cast<Function>(from);
}

} // namespace

Library::Library(const std::string& file) {
  // RTLD_LOCAL: the loader's symbols must not satisfy anybody else's undefined ones.
  handle_ = ::dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (!handle_)
    throw Error(ExitCode::device, "vulkan", "the Vulkan loader " + file + " cannot be loaded",
                "Install it (Debian, Ubuntu: libvulkan1; Fedora: vulkan-loader) with a driver "
                "(mesa-vulkan-drivers needs no GPU), or choose --backend opengl");
  get_ = reinterpret_cast<PFN_vkGetInstanceProcAddr>(::dlsym(handle_, "vkGetInstanceProcAddr"));
  try {
    require(get_, reinterpret_cast<PFN_vkVoidFunction>(get_), "GetInstanceProcAddr", file.c_str());
#define GG_VULKAN_LOAD(NAME) require(NAME, get_(nullptr, "vk" #NAME), #NAME, file.c_str());
    GG_VULKAN_LOAD(CreateInstance)
    GG_VULKAN_LOAD(EnumerateInstanceExtensionProperties)
    GG_VULKAN_LOAD(EnumerateInstanceLayerProperties)
#undef GG_VULKAN_LOAD
  } catch (...) {
    ::dlclose(handle_);
    throw;
  }
  EnumerateInstanceVersion =
      reinterpret_cast<PFN_vkEnumerateInstanceVersion>(get_(nullptr, "vkEnumerateInstanceVersion"));
}

InstanceFunctions Library::functions(VkInstance instance) const {
  InstanceFunctions found;
#define GG_VULKAN_LOAD(NAME)                                                                       \
  require(found.NAME, get_(instance, "vk" #NAME), #NAME, "the Vulkan loader");
  GG_VULKAN_INSTANCE_FUNCTIONS(GG_VULKAN_LOAD)
#undef GG_VULKAN_LOAD
#define GG_VULKAN_LOAD(NAME)                                                                       \
  found.NAME = reinterpret_cast<PFN_vk##NAME>(get_(instance, "vk" #NAME));
  GG_VULKAN_DEBUG_FUNCTIONS(GG_VULKAN_LOAD)
  GG_VULKAN_SURFACE_FUNCTIONS(GG_VULKAN_LOAD)
#undef GG_VULKAN_LOAD
  return found;
}

DeviceFunctions Library::functions(const InstanceFunctions& functions, VkDevice device) {
  DeviceFunctions found;
#define GG_VULKAN_LOAD(NAME)                                                                       \
  require(found.NAME, functions.GetDeviceProcAddr(device, "vk" #NAME), #NAME, "the Vulkan driver");
  GG_VULKAN_DEVICE_FUNCTIONS(GG_VULKAN_LOAD)
#undef GG_VULKAN_LOAD
#define GG_VULKAN_LOAD(NAME)                                                                       \
  found.NAME = reinterpret_cast<PFN_vk##NAME>(functions.GetDeviceProcAddr(device, "vk" #NAME));
  GG_VULKAN_SWAPCHAIN_FUNCTIONS(GG_VULKAN_LOAD)
#undef GG_VULKAN_LOAD
  return found;
}

} // namespace gg::gpu::vulkan
