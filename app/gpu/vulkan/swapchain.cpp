#include "gpu/vulkan/swapchain.h"

#include "core/error.h"

#include <algorithm>
#include <limits>

namespace gg::gpu::vulkan {
namespace {

// What Vulkan lists: asks how many there are, then for them. `ask` is called with the count and where they go.
template <class T, class Ask>
std::vector<T> listed(Ask ask, const char* doing) {
  std::uint32_t count = 0;
  check(ask(&count, nullptr), doing);
  std::vector<T> all(count);
  check(ask(&count, all.data()), doing);
  return all;
}

// Values are encoded for display already: a format that encodes would do it twice.
VkSurfaceFormatKHR format_for(const Context& context, VkSurfaceKHR surface) {
  const InstanceFunctions& vk = context.instance().functions();
  const VkPhysicalDevice device = context.adapter().handle;
  const auto formats = listed<VkSurfaceFormatKHR>(
      [&](std::uint32_t* count, VkSurfaceFormatKHR* all) {
        return vk.GetPhysicalDeviceSurfaceFormatsKHR(device, surface, count, all);
      },
      "asking for the formats of a window");
  for (const VkFormat wanted :
       {VK_FORMAT_B8G8R8A8_UNORM, VK_FORMAT_R8G8B8A8_UNORM, VK_FORMAT_A2B10G10R10_UNORM_PACK32})
    for (const VkSurfaceFormatKHR& format : formats)
      if (format.format == wanted && format.colorSpace == VK_COLOR_SPACE_SRGB_NONLINEAR_KHR)
        return format;
  throw Error(ExitCode::device, "window", "its formats are none that is known",
              "Choose --backend opengl.");
}

VkPresentModeKHR mode_for(const Context& context, VkSurfaceKHR surface, bool wait_for_display) {
  if (wait_for_display) return VK_PRESENT_MODE_FIFO_KHR; // which every device has
  const InstanceFunctions& vk = context.instance().functions();
  const VkPhysicalDevice device = context.adapter().handle;
  const auto modes = listed<VkPresentModeKHR>(
      [&](std::uint32_t* count, VkPresentModeKHR* all) {
        return vk.GetPhysicalDeviceSurfacePresentModesKHR(device, surface, count, all);
      },
      "asking how a window is shown");
  for (const VkPresentModeKHR wanted : {VK_PRESENT_MODE_IMMEDIATE_KHR, VK_PRESENT_MODE_MAILBOX_KHR})
    if (std::ranges::find(modes, wanted) != modes.end()) return wanted;
  return VK_PRESENT_MODE_FIFO_KHR;
}

VkSemaphore semaphore(const Context& context, const char* label) {
  const VkSemaphoreCreateInfo info{.sType = VK_STRUCTURE_TYPE_SEMAPHORE_CREATE_INFO};
  VkSemaphore made = VK_NULL_HANDLE;
  check(context.vk().CreateSemaphore(context.device(), &info, nullptr, &made),
        "making a window's semaphore");
  context.name(VK_OBJECT_TYPE_SEMAPHORE, made, label);
  return made;
}

} // namespace

Swapchain::Swapchain(Context& context, VkSurfaceKHR surface, bool wait_for_display)
    : context_(context), surface_(surface) {
  VkBool32 draws = VK_FALSE;
  check(context.instance().functions().GetPhysicalDeviceSurfaceSupportKHR(
            context.adapter().handle, context.adapter().queue_family, surface, &draws),
        "asking whether the device draws into windows");
  if (!draws)
    throw Error(ExitCode::device, "window",
                context.adapter().info.name + " does not draw into windows of this display",
                "Choose another --device (groundglass devices lists them), or --backend opengl.");
  format_ = format_for(context, surface);
  mode_ = mode_for(context, surface, wait_for_display);
  for (VkSemaphore& acquired : acquired_)
    acquired = semaphore(context, "window acquired");
}

Swapchain::~Swapchain() {
  context_.vk().DeviceWaitIdle(context_.device());
  destroy(chain_);
  for (const VkSemaphore acquired : acquired_)
    context_.vk().DestroySemaphore(context_.device(), acquired, nullptr);
}

void Swapchain::destroy(VkSwapchainKHR chain) {
  for (const VkSemaphore drawn : drawn_)
    context_.vk().DestroySemaphore(context_.device(), drawn, nullptr);
  drawn_.clear();
  images_.clear();
  if (chain) context_.vk().DestroySwapchainKHR(context_.device(), chain, nullptr);
}

void Swapchain::create() {
  const DeviceFunctions& vk = context_.vk();
  vk.DeviceWaitIdle(context_.device());
  VkSurfaceCapabilitiesKHR can{};
  check(context_.instance().functions().GetPhysicalDeviceSurfaceCapabilitiesKHR(
            context_.adapter().handle, surface_, &can),
        "asking for the size of the window");
  constexpr std::uint32_t any = std::numeric_limits<std::uint32_t>::max(); // the images decide
  const auto side = [](std::uint32_t now, int wanted, std::uint32_t least, std::uint32_t most) {
    return now != any ? now : std::clamp(static_cast<std::uint32_t>(wanted), least, most);
  };
  size_ = {
      side(can.currentExtent.width, width_, can.minImageExtent.width, can.maxImageExtent.width),
      side(can.currentExtent.height, height_, can.minImageExtent.height,
           can.maxImageExtent.height)};
  const VkSwapchainKHR before = chain_;
  chain_ = VK_NULL_HANDLE;
  stale_ = false;
  if (size_.width == 0 || size_.height == 0) return destroy(before);

  constexpr std::uint32_t images_wanted = 3; // one shown, one waiting, one drawn
  std::uint32_t count = std::max(images_wanted, can.minImageCount);
  if (can.maxImageCount > 0) count = std::min(count, can.maxImageCount);
  const bool opaque = (can.supportedCompositeAlpha & VK_COMPOSITE_ALPHA_OPAQUE_BIT_KHR) != 0;
  const VkSwapchainCreateInfoKHR info{.sType = VK_STRUCTURE_TYPE_SWAPCHAIN_CREATE_INFO_KHR,
                                      .surface = surface_,
                                      .minImageCount = count,
                                      .imageFormat = format_.format,
                                      .imageColorSpace = format_.colorSpace,
                                      .imageExtent = size_,
                                      .imageArrayLayers = 1,
                                      .imageUsage = VK_IMAGE_USAGE_TRANSFER_DST_BIT,
                                      .imageSharingMode = VK_SHARING_MODE_EXCLUSIVE,
                                      .preTransform = can.currentTransform,
                                      .compositeAlpha = opaque ? VK_COMPOSITE_ALPHA_OPAQUE_BIT_KHR
                                                               : VK_COMPOSITE_ALPHA_INHERIT_BIT_KHR,
                                      .presentMode = mode_,
                                      .clipped = VK_TRUE,
                                      .oldSwapchain = before};
  const VkResult made = vk.CreateSwapchainKHR(context_.device(), &info, nullptr, &chain_);
  destroy(before);
  check(made, "making the images of the window");
  images_ = listed<VkImage>(
      [&](std::uint32_t* found, VkImage* all) {
        return vk.GetSwapchainImagesKHR(context_.device(), chain_, found, all);
      },
      "taking the images of the window");
  for (const VkImage image : images_) {
    context_.name(VK_OBJECT_TYPE_IMAGE, image, "window");
    drawn_.push_back(semaphore(context_, "window drawn"));
  }
}

std::optional<Swapchain::Next> Swapchain::acquire(int width, int height) {
  stale_ |= width != width_ || height != height_;
  width_ = width, height_ = height;
  constexpr int tries = 4; // of a window that changes while its images are made
  for (int i = 0; i < tries; ++i) {
    if (stale_) create();
    if (!chain_) {
      stale_ = true;
      return std::nullopt;
    }
    Next next{.acquired = acquired_[turn_]};
    const VkResult result = context_.vk().AcquireNextImageKHR(
        context_.device(), chain_, std::numeric_limits<std::uint64_t>::max(), next.acquired,
        VK_NULL_HANDLE, &next.index);
    if (result == VK_ERROR_OUT_OF_DATE_KHR) {
      stale_ = true;
      continue;
    }
    if (result == VK_SUBOPTIMAL_KHR)
      stale_ = true; // from the next picture on
    else
      check(result, "waiting for an image of the window");
    turn_ = (turn_ + 1) % acquired_.size();
    next.drawn = drawn_[next.index];
    return next;
  }
  return std::nullopt;
}

void Swapchain::fill(VkCommandBuffer commands, const Next& next, const GpuTexture& from) const {
  const DeviceFunctions& vk = context_.vk();
  const VkImageSubresourceRange all{VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0, 1};
  const auto change = [&](VkPipelineStageFlags2 before, VkAccessFlags2 written, VkImageLayout old,
                          VkPipelineStageFlags2 after, VkAccessFlags2 access, VkImageLayout now) {
    const VkImageMemoryBarrier2 barrier{.sType = VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER_2,
                                        .srcStageMask = before,
                                        .srcAccessMask = written,
                                        .dstStageMask = after,
                                        .dstAccessMask = access,
                                        .oldLayout = old,
                                        .newLayout = now,
                                        .srcQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED,
                                        .dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED,
                                        .image = images_[next.index],
                                        .subresourceRange = all};
    const VkDependencyInfo info{.sType = VK_STRUCTURE_TYPE_DEPENDENCY_INFO,
                                .imageMemoryBarrierCount = 1,
                                .pImageMemoryBarriers = &barrier};
    vk.CmdPipelineBarrier2(commands, &info);
  };
  constexpr VkPipelineStageFlags2 copies = VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT;
  change(copies, 0, VK_IMAGE_LAYOUT_UNDEFINED, copies, VK_ACCESS_2_TRANSFER_WRITE_BIT,
         VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL);
  const VkExtent2D part{std::min(size_.width, static_cast<std::uint32_t>(from.desc.width)),
                        std::min(size_.height, static_cast<std::uint32_t>(from.desc.height))};
  if (part.width < size_.width || part.height < size_.height) { // the window has grown meanwhile
    const VkClearColorValue black{};
    vk.CmdClearColorImage(commands, images_[next.index], VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL,
                          &black, 1, &all);
    change(copies, VK_ACCESS_2_TRANSFER_WRITE_BIT, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, copies,
           VK_ACCESS_2_TRANSFER_WRITE_BIT, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL);
  }
  // Not a copy: the order of the channels differs.
  const VkOffset3D end{static_cast<int>(part.width), static_cast<int>(part.height), 1};
  const VkImageBlit2 region{.sType = VK_STRUCTURE_TYPE_IMAGE_BLIT_2,
                            .srcSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1},
                            .srcOffsets = {{}, end},
                            .dstSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1},
                            .dstOffsets = {{}, end}};
  const VkBlitImageInfo2 blit{.sType = VK_STRUCTURE_TYPE_BLIT_IMAGE_INFO_2,
                              .srcImage = from.handle,
                              .srcImageLayout = VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL,
                              .dstImage = images_[next.index],
                              .dstImageLayout = VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL,
                              .regionCount = 1,
                              .pRegions = &region,
                              .filter = VK_FILTER_NEAREST};
  vk.CmdBlitImage2(commands, &blit);
  change(copies, VK_ACCESS_2_TRANSFER_WRITE_BIT, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, copies, 0,
         VK_IMAGE_LAYOUT_PRESENT_SRC_KHR);
}

void Swapchain::present(const Next& next) {
  const VkPresentInfoKHR info{.sType = VK_STRUCTURE_TYPE_PRESENT_INFO_KHR,
                              .waitSemaphoreCount = 1,
                              .pWaitSemaphores = &next.drawn,
                              .swapchainCount = 1,
                              .pSwapchains = &chain_,
                              .pImageIndices = &next.index};
  const VkResult result = context_.vk().QueuePresentKHR(context_.queue(), &info);
  if (result == VK_ERROR_OUT_OF_DATE_KHR || result == VK_SUBOPTIMAL_KHR)
    stale_ = true;
  else
    check(result, "showing the window");
}

} // namespace gg::gpu::vulkan
