// The Vulkan entry points that this library calls, found at run time: a machine without a Vulkan driver gets a message that says
// what to install. (Dear ImGui calls the loader itself.)
#pragma once

#define VK_NO_PROTOTYPES
#include <vulkan/vulkan_core.h>

#include <memory>
#include <string>

namespace gg::gpu::vulkan {

#define GG_VULKAN_INSTANCE_FUNCTIONS(F)                                                            \
  F(DestroyInstance)                                                                               \
  F(EnumeratePhysicalDevices)                                                                      \
  F(EnumerateDeviceExtensionProperties)                                                            \
  F(GetPhysicalDeviceProperties2)                                                                  \
  F(GetPhysicalDeviceFeatures2)                                                                    \
  F(GetPhysicalDeviceFormatProperties2)                                                            \
  F(GetPhysicalDeviceImageFormatProperties2)                                                       \
  F(GetPhysicalDeviceMemoryProperties2)                                                            \
  F(GetPhysicalDeviceQueueFamilyProperties2)                                                       \
  F(CreateDevice)                                                                                  \
  F(GetDeviceProcAddr)

// Of VK_EXT_debug_utils: null where the loader does not have it.
#define GG_VULKAN_DEBUG_FUNCTIONS(F)                                                               \
  F(CreateDebugUtilsMessengerEXT)                                                                  \
  F(DestroyDebugUtilsMessengerEXT)                                                                 \
  F(SetDebugUtilsObjectNameEXT)                                                                    \
  F(CmdBeginDebugUtilsLabelEXT)                                                                    \
  F(CmdEndDebugUtilsLabelEXT)

// Of VK_KHR_surface and VK_KHR_swapchain: null where no window is drawn into.
#define GG_VULKAN_SURFACE_FUNCTIONS(F)                                                             \
  F(DestroySurfaceKHR)                                                                             \
  F(GetPhysicalDeviceSurfaceSupportKHR)                                                            \
  F(GetPhysicalDeviceSurfaceCapabilitiesKHR)                                                       \
  F(GetPhysicalDeviceSurfaceFormatsKHR)                                                            \
  F(GetPhysicalDeviceSurfacePresentModesKHR)
#define GG_VULKAN_SWAPCHAIN_FUNCTIONS(F)                                                           \
  F(CreateSwapchainKHR)                                                                            \
  F(DestroySwapchainKHR)                                                                           \
  F(GetSwapchainImagesKHR)                                                                         \
  F(AcquireNextImageKHR)                                                                           \
  F(QueuePresentKHR)

#define GG_VULKAN_DEVICE_FUNCTIONS(F)                                                              \
  F(DestroyDevice)                                                                                 \
  F(GetDeviceQueue)                                                                                \
  F(DeviceWaitIdle)                                                                                \
  F(QueueSubmit2)                                                                                  \
  F(AllocateMemory)                                                                                \
  F(FreeMemory)                                                                                    \
  F(MapMemory)                                                                                     \
  F(CreateBuffer)                                                                                  \
  F(DestroyBuffer)                                                                                 \
  F(GetBufferMemoryRequirements2)                                                                  \
  F(BindBufferMemory2)                                                                             \
  F(CreateImage)                                                                                   \
  F(DestroyImage)                                                                                  \
  F(GetImageMemoryRequirements2)                                                                   \
  F(BindImageMemory2)                                                                              \
  F(CreateImageView)                                                                               \
  F(DestroyImageView)                                                                              \
  F(CreateSampler)                                                                                 \
  F(DestroySampler)                                                                                \
  F(CreateShaderModule)                                                                            \
  F(DestroyShaderModule)                                                                           \
  F(CreatePipelineCache)                                                                           \
  F(DestroyPipelineCache)                                                                          \
  F(GetPipelineCacheData)                                                                          \
  F(CreatePipelineLayout)                                                                          \
  F(DestroyPipelineLayout)                                                                         \
  F(CreateGraphicsPipelines)                                                                       \
  F(CreateComputePipelines)                                                                        \
  F(DestroyPipeline)                                                                               \
  F(CreateDescriptorSetLayout)                                                                     \
  F(DestroyDescriptorSetLayout)                                                                    \
  F(CreateDescriptorPool)                                                                          \
  F(DestroyDescriptorPool)                                                                         \
  F(AllocateDescriptorSets)                                                                        \
  F(UpdateDescriptorSets)                                                                          \
  F(CreateSemaphore)                                                                               \
  F(DestroySemaphore)                                                                              \
  F(WaitSemaphores)                                                                                \
  F(GetSemaphoreCounterValue)                                                                      \
  F(CreateQueryPool)                                                                               \
  F(DestroyQueryPool)                                                                              \
  F(GetQueryPoolResults)                                                                           \
  F(CreateCommandPool)                                                                             \
  F(DestroyCommandPool)                                                                            \
  F(ResetCommandPool)                                                                              \
  F(AllocateCommandBuffers)                                                                        \
  F(BeginCommandBuffer)                                                                            \
  F(EndCommandBuffer)                                                                              \
  F(CmdPipelineBarrier2)                                                                           \
  F(CreateRenderPass)                                                                              \
  F(DestroyRenderPass)                                                                             \
  F(CreateFramebuffer)                                                                             \
  F(DestroyFramebuffer)                                                                            \
  F(CmdBeginRenderPass)                                                                            \
  F(CmdEndRenderPass)                                                                              \
  F(CmdBeginRendering)                                                                             \
  F(CmdEndRendering)                                                                               \
  F(CmdSetViewport)                                                                                \
  F(CmdSetScissor)                                                                                 \
  F(CmdSetCullMode)                                                                                \
  F(CmdSetFrontFace)                                                                               \
  F(CmdBindPipeline)                                                                               \
  F(CmdBindDescriptorSets)                                                                         \
  F(CmdBindVertexBuffers)                                                                          \
  F(CmdBindIndexBuffer)                                                                            \
  F(CmdDraw)                                                                                       \
  F(CmdDrawIndexed)                                                                                \
  F(CmdDispatch)                                                                                   \
  F(CmdCopyBuffer2)                                                                                \
  F(CmdCopyBufferToImage2)                                                                         \
  F(CmdCopyImageToBuffer2)                                                                         \
  F(CmdBlitImage2)                                                                                 \
  F(CmdClearColorImage)                                                                            \
  F(CmdClearDepthStencilImage)                                                                     \
  F(CmdFillBuffer)                                                                                 \
  F(CmdResetQueryPool)                                                                             \
  F(CmdWriteTimestamp2)

#define GG_VULKAN_MEMBER(NAME) PFN_vk##NAME NAME = nullptr;
struct InstanceFunctions {
  GG_VULKAN_INSTANCE_FUNCTIONS(GG_VULKAN_MEMBER)
  GG_VULKAN_DEBUG_FUNCTIONS(GG_VULKAN_MEMBER)
  GG_VULKAN_SURFACE_FUNCTIONS(GG_VULKAN_MEMBER)
};
struct DeviceFunctions {
  GG_VULKAN_DEVICE_FUNCTIONS(GG_VULKAN_MEMBER)
  GG_VULKAN_SWAPCHAIN_FUNCTIONS(GG_VULKAN_MEMBER)
};
#undef GG_VULKAN_MEMBER

// The loader, libvulkan.so.1, and the entry points that need no instance. Once it has been found good it is never closed: an
// instance stays open (instance.cpp).
class Library {
public:
  // Throws Error(device) if `file` cannot be loaded or is no Vulkan loader.
  explicit Library(const std::string& file = "libvulkan.so.1");
  Library(const Library&) = delete;
  Library& operator=(const Library&) = delete;

  // Throw Error(device) naming an entry point that is missing (those of extensions may be).
  InstanceFunctions functions(VkInstance instance) const;
  static DeviceFunctions functions(const InstanceFunctions& functions, VkDevice device);

  PFN_vkCreateInstance CreateInstance = nullptr;
  PFN_vkEnumerateInstanceVersion EnumerateInstanceVersion = nullptr; // null in Vulkan 1.0
  PFN_vkEnumerateInstanceExtensionProperties EnumerateInstanceExtensionProperties = nullptr;
  PFN_vkEnumerateInstanceLayerProperties EnumerateInstanceLayerProperties = nullptr;

private:
  void* handle_ = nullptr;
  PFN_vkGetInstanceProcAddr get_ = nullptr;
};

// The handle as the number that VK_EXT_debug_utils and hash tables want.
template <typename Handle>
std::uint64_t number_of(Handle handle) {
  return reinterpret_cast<std::uint64_t>(handle);
}

} // namespace gg::gpu::vulkan
