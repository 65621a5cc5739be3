// Dear ImGui's panels, drawn by its own Vulkan backend.
#pragma once

#include "gpu/vulkan/context.h"
#include "gpu/vulkan/device.h"
#include "gpu/vulkan/resources.h"

#include <memory>

namespace gg::gpu::vulkan {

class Panels {
public:
  // Dear ImGui's context is there.
  explicit Panels(std::shared_ptr<Context> context);
  ~Panels();
  Panels(const Panels&) = delete;
  Panels& operator=(const Panels&) = delete;

  // Before Dear ImGui's own. Its letters, which are complete by the first frame, go to the device.
  void begin_frame(VulkanDevice& device);
  // Over a texture (rgba8, Use::attachment) that is a colour target by now.
  void draw(VkCommandBuffer commands, const TextureRef& target);

private:
  void aim_at(const TextureRef& target);
  void let_go(); // of the framebuffer, when the device has drawn into it

  std::shared_ptr<Context> context_;
  VkDescriptorPool pool_ = VK_NULL_HANDLE;
  VkRenderPass render_pass_ = VK_NULL_HANDLE;
  VkFramebuffer framebuffer_ = VK_NULL_HANDLE;
  TextureRef target_; // of the framebuffer
  bool has_letters_ = false;
};

} // namespace gg::gpu::vulkan
