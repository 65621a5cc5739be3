// The images that a window shows in turn.
#pragma once

#include "gpu/vulkan/context.h"
#include "gpu/vulkan/resources.h"

#include <array>
#include <optional>
#include <vector>

namespace gg::gpu::vulkan {

class Swapchain {
public:
  // Of a surface that outlives it. Throws Error(device) if the device does not draw into such windows.
  Swapchain(Context& context, VkSurfaceKHR surface, bool wait_for_display);
  ~Swapchain();
  Swapchain(const Swapchain&) = delete;
  Swapchain& operator=(const Swapchain&) = delete;

  struct Next {
    std::uint32_t index = 0;
    VkSemaphore acquired =
        VK_NULL_HANDLE; // to be waited for by what copies into it (VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT),
    VkSemaphore drawn = VK_NULL_HANDLE; // to be signalled when that is done
  };
  // The image that comes next; nothing while there is no area to draw into. The swapchain is created again where the window has
  // another size (pixels) than before, or the display says so.
  std::optional<Next> acquire(int width, int height);
  // Copies a texture (rgba8, in the layout for copying from) to its top left, and leaves it ready to be shown.
  void fill(VkCommandBuffer commands, const Next& next, const GpuTexture& from) const;
  void present(const Next& next);

private:
  void create();
  void destroy(VkSwapchainKHR chain);

  Context& context_;
  VkSurfaceKHR surface_;
  VkSurfaceFormatKHR format_{};
  VkPresentModeKHR mode_ = VK_PRESENT_MODE_FIFO_KHR;
  VkSwapchainKHR chain_ = VK_NULL_HANDLE;
  VkExtent2D size_{};          // of the images
  int width_ = 0, height_ = 0; // of the window that they were made for
  bool stale_ = true;          // the window has changed
  std::vector<VkImage> images_;
  std::vector<VkSemaphore> drawn_; // by image
  // More than submissions that may be under way (commands.h), so that none is still waited for when its turn comes again.
  std::array<VkSemaphore, 4> acquired_{};
  std::size_t turn_ = 0;
};

} // namespace gg::gpu::vulkan
