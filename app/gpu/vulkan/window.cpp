#include "gpu/vulkan/window.h"

#include "core/error.h"
#include "gpu/backends.h"

#include <imgui.h>

#include <span>

namespace gg::gpu::vulkan {
namespace {

// What the display's windows need of an instance.
std::span<const char* const> extensions() {
  std::uint32_t count = 0;
  const char** names = glfwGetRequiredInstanceExtensions(&count);
  if (!names)
    throw Error(ExitCode::device, "window", "no Vulkan driver draws into windows of this display",
                "Install one (Debian, Ubuntu: libvulkan1 and mesa-vulkan-drivers), or choose "
                "--backend opengl; groundglass capture draws without a window.");
  return {names, count};
}

} // namespace

VulkanWindow::VulkanWindow(const WindowDesc& desc)
    : DesktopWindow(desc, false),
      context_(std::make_shared<Context>(
          DeviceDesc{.backend = Backend::vulkan, .device = desc.device, .debug = desc.debug},
          extensions())) {
  check(
      glfwCreateWindowSurface(context_->instance().handle(), window_.handle(), nullptr, &surface_),
      "opening the window");
  try {
    device_ = std::make_unique<VulkanDevice>(context_);
    swapchain_ = std::make_unique<Swapchain>(*context_, surface_, desc.wait_for_display);
    window_.start_panels();
    panels_ = std::make_unique<Panels>(context_);
  } catch (...) {
    swapchain_.reset();
    context_->instance().functions().DestroySurfaceKHR(context_->instance().handle(), surface_,
                                                       nullptr);
    throw;
  }
}

VulkanWindow::~VulkanWindow() {
  panels_.reset();
  swapchain_.reset();
  context_->instance().functions().DestroySurfaceKHR(context_->instance().handle(), surface_,
                                                     nullptr);
}

void VulkanWindow::begin_frame() {
  panels_->begin_frame(*device_);
  window_.begin_panels();
}

void VulkanWindow::present(const TextureRef& picture, std::vector<std::byte>* shown) {
  ImGui::Render();
  if (width() == 0 || height() == 0) return;
  const auto next = swapchain_->acquire(width(), height());
  const auto draw = [&](VkCommandBuffer commands, Barriers& barriers) {
    GpuTexture& drawn = of(picture);
    barriers.add(commands, drawn, drawn.all(), color_target(false));
    barriers.issue(commands);
    panels_->draw(commands, picture);
    barriers.add(commands, drawn, drawn.all(), copied_from());
    barriers.issue(commands);
    if (next) swapchain_->fill(commands, *next, drawn);
  };
  device_->submit(draw, next ? Around{next->acquired, next->drawn} : Around{});
  if (next) swapchain_->present(*next);
  if (shown) *shown = device_->read(picture, 0, 0);
}

std::unique_ptr<Window> create_window(const WindowDesc& desc) {
  return std::make_unique<VulkanWindow>(desc);
}

} // namespace gg::gpu::vulkan
