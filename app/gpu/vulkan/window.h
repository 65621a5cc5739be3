// A window that Vulkan draws into.
#pragma once

#include "gpu/surface/desktop_window.h"
#include "gpu/vulkan/device.h"
#include "gpu/vulkan/panels.h"
#include "gpu/vulkan/swapchain.h"

namespace gg::gpu::vulkan {

class VulkanWindow final : public surface::DesktopWindow {
public:
  explicit VulkanWindow(const WindowDesc& desc);
  ~VulkanWindow() override;

  Device& device() override { return *device_; }
  void begin_frame() override;
  void present(const TextureRef& picture, std::vector<std::byte>* shown) override;

private:
  std::shared_ptr<Context> context_;
  VkSurfaceKHR surface_ = VK_NULL_HANDLE;
  std::unique_ptr<VulkanDevice> device_;
  std::unique_ptr<Swapchain> swapchain_;
  std::unique_ptr<Panels> panels_;
};

} // namespace gg::gpu::vulkan
