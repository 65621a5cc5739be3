#include "gpu/vulkan/result.h"

#include <fmt/format.h>

namespace gg::gpu::vulkan {

namespace {

struct Meaning {
  std::string what, remedy;
};

Meaning meaning_of(VkResult result) {
  switch (result) {
  case VK_ERROR_OUT_OF_HOST_MEMORY:
    return {"the machine is out of memory", "Close other programs or lower --size"};
  case VK_ERROR_OUT_OF_DEVICE_MEMORY:
    return {"the device is out of memory",
            "Lower --size, use smaller textures, or choose another --device"};
  case VK_ERROR_DEVICE_LOST:
    return {"the device was lost (a driver reset, an unplugged or a hung GPU)",
            "Run again; if it persists update the driver, choose another --device, or --backend "
            "opengl"};
  case VK_ERROR_INITIALIZATION_FAILED:
    return {"the driver could not be initialised",
            "Check the driver with vulkaninfo, choose another --device, or --backend opengl"};
  case VK_ERROR_INCOMPATIBLE_DRIVER:
    return {"no usable Vulkan driver is installed",
            "Install the GPU's driver, or one that needs no GPU (Debian, Ubuntu: "
            "mesa-vulkan-drivers); check VK_ICD_FILENAMES and VK_DRIVER_FILES if they are set; or "
            "choose --backend opengl"};
  case VK_ERROR_LAYER_NOT_PRESENT:
    return {"a layer that was asked for is not installed",
            "Install it (Debian, Ubuntu: vulkan-validationlayers) or unset VK_INSTANCE_LAYERS"};
  case VK_ERROR_SURFACE_LOST_KHR:
    return {"the window is gone", "Open it again; groundglass capture draws without a window"};
  case VK_ERROR_TOO_MANY_OBJECTS:
    return {"the driver has no room for more objects", "Use a scene with fewer textures"};
  default:
    return {fmt::format("the driver answered VkResult {}", static_cast<int>(result)),
            "Update the driver, choose another --device, or --backend opengl"};
  }
}

} // namespace

Error error_of(VkResult result, const std::string& doing) {
  const Meaning meaning = meaning_of(result);
  return Error(ExitCode::device, "vulkan", meaning.what + " while " + doing, meaning.remedy);
}

std::string in_words(std::uint64_t bytes) {
  if (bytes < 1024) return fmt::format("{} bytes", bytes);
  const double kib = static_cast<double>(bytes) / 1024.0;
  if (kib < 1024.0) return fmt::format("{:.1f} KiB", kib);
  if (kib < 1024.0 * 1024.0) return fmt::format("{:.1f} MiB", kib / 1024.0);
  return fmt::format("{:.1f} GiB", kib / (1024.0 * 1024.0));
}

} // namespace gg::gpu::vulkan
