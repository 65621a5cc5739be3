#include "gpu/vulkan/panels.h"

#include "gpu/vulkan/formats.h"

#include <backends/imgui_impl_vulkan.h>
#include <imgui.h>

namespace gg::gpu::vulkan {
namespace {

void check_panels(VkResult result) {
  check(result, "drawing the panels");
}

VkDescriptorPool make_pool(const Context& context) {
  const VkDescriptorPoolSize size{VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, 1}; // the letters
  const VkDescriptorPoolCreateInfo info{.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO,
                                        .maxSets = 1,
                                        .poolSizeCount = 1,
                                        .pPoolSizes = &size};
  VkDescriptorPool pool = VK_NULL_HANDLE;
  check(context.vk().CreateDescriptorPool(context.device(), &info, nullptr, &pool),
        "making room for the panels");
  context.name(VK_OBJECT_TYPE_DESCRIPTOR_POOL, pool, "panels");
  return pool;
}

// Dear ImGui 1.86 draws in render passes. Its target is in the layout for drawing before and after.
VkRenderPass make_render_pass(const Context& context) {
  const VkAttachmentDescription color{.format = format_of(Format::rgba8),
                                      .samples = VK_SAMPLE_COUNT_1_BIT,
                                      .loadOp = VK_ATTACHMENT_LOAD_OP_LOAD,
                                      .storeOp = VK_ATTACHMENT_STORE_OP_STORE,
                                      .stencilLoadOp = VK_ATTACHMENT_LOAD_OP_DONT_CARE,
                                      .stencilStoreOp = VK_ATTACHMENT_STORE_OP_DONT_CARE,
                                      .initialLayout = VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL,
                                      .finalLayout = VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL};
  const VkAttachmentReference reference{0, VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL};
  const VkSubpassDescription subpass{.pipelineBindPoint = VK_PIPELINE_BIND_POINT_GRAPHICS,
                                     .colorAttachmentCount = 1,
                                     .pColorAttachments = &reference};
  const VkRenderPassCreateInfo info{.sType = VK_STRUCTURE_TYPE_RENDER_PASS_CREATE_INFO,
                                    .attachmentCount = 1,
                                    .pAttachments = &color,
                                    .subpassCount = 1,
                                    .pSubpasses = &subpass};
  VkRenderPass pass = VK_NULL_HANDLE;
  check(context.vk().CreateRenderPass(context.device(), &info, nullptr, &pass),
        "making the panels' pass");
  context.name(VK_OBJECT_TYPE_RENDER_PASS, pass, "panels");
  return pass;
}

} // namespace

Panels::Panels(std::shared_ptr<Context> context)
    : context_(std::move(context)), pool_(make_pool(*context_)),
      render_pass_(make_render_pass(*context_)) {
  // Vertices are kept for as many frames: one more than may be under way (commands.h).
  constexpr std::uint32_t frames = 4;
  ImGui_ImplVulkan_InitInfo info{};
  info.Instance = context_->instance().handle();
  info.PhysicalDevice = context_->adapter().handle;
  info.Device = context_->device();
  info.QueueFamily = context_->adapter().queue_family;
  info.Queue = context_->queue();
  info.DescriptorPool = pool_;
  info.MinImageCount = 2;
  info.ImageCount = frames;
  info.MSAASamples = VK_SAMPLE_COUNT_1_BIT;
  info.CheckVkResultFn = check_panels;
  ImGui_ImplVulkan_Init(&info, render_pass_);
}

Panels::~Panels() {
  context_->vk().DeviceWaitIdle(context_->device());
  ImGui_ImplVulkan_Shutdown();
  let_go();
  context_->vk().DestroyRenderPass(context_->device(), render_pass_, nullptr);
  context_->vk().DestroyDescriptorPool(context_->device(), pool_, nullptr);
}

void Panels::begin_frame(VulkanDevice& device) {
  if (!has_letters_) {
    device.submit(
        [](VkCommandBuffer commands, Barriers&) { ImGui_ImplVulkan_CreateFontsTexture(commands); });
    device.finish();
    ImGui_ImplVulkan_DestroyFontUploadObjects();
    has_letters_ = true;
  }
  ImGui_ImplVulkan_NewFrame();
}

void Panels::let_go() {
  if (!framebuffer_) return;
  context_->retire([&shared = *context_, framebuffer = framebuffer_] {
    shared.vk().DestroyFramebuffer(shared.device(), framebuffer, nullptr);
  });
  framebuffer_ = VK_NULL_HANDLE;
  target_.reset();
}

void Panels::aim_at(const TextureRef& target) {
  if (target_ == target) return;
  let_go();
  const VkImageView view = of(target).attachment(whole(target));
  const VkFramebufferCreateInfo info{.sType = VK_STRUCTURE_TYPE_FRAMEBUFFER_CREATE_INFO,
                                     .renderPass = render_pass_,
                                     .attachmentCount = 1,
                                     .pAttachments = &view,
                                     .width = static_cast<std::uint32_t>(target->desc.width),
                                     .height = static_cast<std::uint32_t>(target->desc.height),
                                     .layers = 1};
  check(context_->vk().CreateFramebuffer(context_->device(), &info, nullptr, &framebuffer_),
        "aiming the panels");
  context_->name(VK_OBJECT_TYPE_FRAMEBUFFER, framebuffer_, "panels");
  target_ = target;
}

void Panels::draw(VkCommandBuffer commands, const TextureRef& target) {
  aim_at(target);
  const VkRenderPassBeginInfo begin{
      .sType = VK_STRUCTURE_TYPE_RENDER_PASS_BEGIN_INFO,
      .renderPass = render_pass_,
      .framebuffer = framebuffer_,
      .renderArea = {.extent = {static_cast<std::uint32_t>(target->desc.width),
                                static_cast<std::uint32_t>(target->desc.height)}}};
  context_->begin_label(commands, "panels");
  context_->vk().CmdBeginRenderPass(commands, &begin, VK_SUBPASS_CONTENTS_INLINE);
  ImGui_ImplVulkan_RenderDrawData(ImGui::GetDrawData(), commands);
  context_->vk().CmdEndRenderPass(commands);
  context_->end_label(commands);
}

} // namespace gg::gpu::vulkan
