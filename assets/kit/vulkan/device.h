// A Vulkan device without a window, its buffers, images and samplers: what main.cpp draws with.
#pragma once

#include "scene.h"

#include <vulkan/vulkan.h>

#include <cstring>

inline void check(VkResult result, const char* what) {
  if (result != VK_SUCCESS) fail(std::string(what) + " failed: VkResult " + std::to_string(result));
}

inline VkInstance instance;
inline VkPhysicalDevice physical;
inline VkDevice device;
inline VkQueue queue;
inline VkCommandPool commands;
inline VkPhysicalDeviceProperties properties;

inline void open_device() {
  const VkApplicationInfo application{.sType = VK_STRUCTURE_TYPE_APPLICATION_INFO,
                                      .apiVersion = VK_API_VERSION_1_3};
  const VkInstanceCreateInfo wanted{.sType = VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO,
                                    .pApplicationInfo = &application};
  check(vkCreateInstance(&wanted, nullptr, &instance), "vkCreateInstance");
  std::uint32_t count = 1;
  if (vkEnumeratePhysicalDevices(instance, &count, &physical) < 0 || count == 0)
    fail("no Vulkan device");
  vkGetPhysicalDeviceProperties(physical, &properties);
  const float priority = 1.0F; // family 0 draws on every device that draws at all
  const VkDeviceQueueCreateInfo queues{.sType = VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO,
                                       .queueCount = 1,
                                       .pQueuePriorities = &priority};
  VkPhysicalDeviceVulkan13Features modern{.sType =
                                              VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_3_FEATURES,
                                          .synchronization2 = VK_TRUE,
                                          .dynamicRendering = VK_TRUE};
  const VkDeviceCreateInfo made{.sType = VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO,
                                .pNext = &modern,
                                .queueCreateInfoCount = 1,
                                .pQueueCreateInfos = &queues};
  check(vkCreateDevice(physical, &made, nullptr, &device), "vkCreateDevice (Vulkan 1.3)");
  vkGetDeviceQueue(device, 0, 0, &queue);
  const VkCommandPoolCreateInfo pool{.sType = VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO,
                                     .flags = VK_COMMAND_POOL_CREATE_RESET_COMMAND_BUFFER_BIT};
  check(vkCreateCommandPool(device, &pool, nullptr, &commands), "vkCreateCommandPool");
}

inline VkDeviceMemory memory_for(const VkMemoryRequirements& needs, VkMemoryPropertyFlags wanted) {
  VkPhysicalDeviceMemoryProperties memory;
  vkGetPhysicalDeviceMemoryProperties(physical, &memory);
  for (std::uint32_t k = 0; k < memory.memoryTypeCount; ++k) {
    if (!(needs.memoryTypeBits >> k & 1U)
        || (memory.memoryTypes[k].propertyFlags & wanted) != wanted)
      continue;
    const VkMemoryAllocateInfo asked{.sType = VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO,
                                     .allocationSize = needs.size,
                                     .memoryTypeIndex = k};
    VkDeviceMemory found;
    check(vkAllocateMemory(device, &asked, nullptr, &found), "vkAllocateMemory");
    return found;
  }
  fail("no memory of the kind that is needed");
}

struct Buffer {
  VkBuffer buffer = VK_NULL_HANDLE;
  unsigned char* data = nullptr; // mapped
};
inline Buffer buffer_of(std::size_t bytes, VkBufferUsageFlags usage, const void* from = nullptr) {
  Buffer made;
  const VkBufferCreateInfo asked{
      .sType = VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO, .size = bytes, .usage = usage};
  check(vkCreateBuffer(device, &asked, nullptr, &made.buffer), "vkCreateBuffer");
  VkMemoryRequirements needs;
  vkGetBufferMemoryRequirements(device, made.buffer, &needs);
  const VkDeviceMemory memory =
      memory_for(needs, VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT);
  vkBindBufferMemory(device, made.buffer, memory, 0);
  check(vkMapMemory(device, memory, 0, VK_WHOLE_SIZE, 0, reinterpret_cast<void**>(&made.data)),
        "vkMapMemory");
  if (from) std::memcpy(made.data, from, bytes);
  return made;
}

inline VkCommandBuffer begin() {
  const VkCommandBufferAllocateInfo asked{.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO,
                                          .commandPool = commands,
                                          .commandBufferCount = 1};
  VkCommandBuffer made;
  check(vkAllocateCommandBuffers(device, &asked, &made), "vkAllocateCommandBuffers");
  const VkCommandBufferBeginInfo once{.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO,
                                      .flags = VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT};
  vkBeginCommandBuffer(made, &once);
  return made;
}
inline void finish(VkCommandBuffer buffer) {
  vkEndCommandBuffer(buffer);
  const VkSubmitInfo work{
      .sType = VK_STRUCTURE_TYPE_SUBMIT_INFO, .commandBufferCount = 1, .pCommandBuffers = &buffer};
  check(vkQueueSubmit(queue, 1, &work, VK_NULL_HANDLE), "vkQueueSubmit");
  check(vkQueueWaitIdle(queue), "vkQueueWaitIdle");
  vkFreeCommandBuffers(device, commands, 1, &buffer);
}

// All images stay in VK_IMAGE_LAYOUT_GENERAL, and everything before a pass is done before it: simple, not fastest.
inline void wait(VkCommandBuffer buffer) {
  const VkMemoryBarrier2 all{.sType = VK_STRUCTURE_TYPE_MEMORY_BARRIER_2,
                             .srcStageMask = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT,
                             .srcAccessMask = VK_ACCESS_2_MEMORY_WRITE_BIT,
                             .dstStageMask = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT,
                             .dstAccessMask =
                                 VK_ACCESS_2_MEMORY_READ_BIT | VK_ACCESS_2_MEMORY_WRITE_BIT};
  const VkDependencyInfo dependency{
      .sType = VK_STRUCTURE_TYPE_DEPENDENCY_INFO, .memoryBarrierCount = 1, .pMemoryBarriers = &all};
  vkCmdPipelineBarrier2(buffer, &dependency);
}

struct Image {
  VkImage image;
  VkFormat format;
  std::array<int, 3> size;
  int levels;
  VkImageAspectFlags aspect;
  VkImageView all;                // to read
  std::vector<VkImageView> level; // to draw into, and to read one alone
};

inline Image image_of(VkFormat format, std::array<int, 3> size, int levels = 1) {
  const bool depth = format == VK_FORMAT_D32_SFLOAT, volume = size[2] > 1;
  Image made{VK_NULL_HANDLE,
             format,
             size,
             levels,
             VkImageAspectFlags(depth ? VK_IMAGE_ASPECT_DEPTH_BIT : VK_IMAGE_ASPECT_COLOR_BIT),
             VK_NULL_HANDLE,
             {}};
  const bool drawn =
      format == VK_FORMAT_R16G16B16A16_SFLOAT || format == VK_FORMAT_R32G32B32A32_SFLOAT;
  const VkImageUsageFlags usage = VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT
                                  | VK_IMAGE_USAGE_TRANSFER_SRC_BIT
                                  | (depth ? VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT
                                     : drawn && !volume ? VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT
                                                        : 0);
  const VkImageCreateInfo asked{
      .sType = VK_STRUCTURE_TYPE_IMAGE_CREATE_INFO,
      .imageType = volume ? VK_IMAGE_TYPE_3D : VK_IMAGE_TYPE_2D,
      .format = format,
      .extent = {std::uint32_t(size[0]), std::uint32_t(size[1]), std::uint32_t(size[2])},
      .mipLevels = std::uint32_t(levels),
      .arrayLayers = 1,
      .samples = VK_SAMPLE_COUNT_1_BIT,
      .usage = usage};
  check(vkCreateImage(device, &asked, nullptr, &made.image), "vkCreateImage");
  VkMemoryRequirements needs;
  vkGetImageMemoryRequirements(device, made.image, &needs);
  check(vkBindImageMemory(device, made.image,
                          memory_for(needs, VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT), 0),
        "vkBindImageMemory");
  for (int k = -1; k < levels; ++k) {
    const VkImageViewCreateInfo view{
        .sType = VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO,
        .image = made.image,
        .viewType = volume ? VK_IMAGE_VIEW_TYPE_3D : VK_IMAGE_VIEW_TYPE_2D,
        .format = format,
        .subresourceRange = {made.aspect, std::uint32_t(std::max(k, 0)),
                             k < 0 ? std::uint32_t(levels) : 1, 0, 1}};
    VkImageView one;
    check(vkCreateImageView(device, &view, nullptr, &one), "vkCreateImageView");
    if (k < 0)
      made.all = one;
    else
      made.level.push_back(one);
  }
  const VkCommandBuffer buffer = begin();
  const VkImageMemoryBarrier2 general{
      .sType = VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER_2,
      .srcStageMask = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT,
      .dstStageMask = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT,
      .dstAccessMask = VK_ACCESS_2_MEMORY_WRITE_BIT,
      .oldLayout = VK_IMAGE_LAYOUT_UNDEFINED,
      .newLayout = VK_IMAGE_LAYOUT_GENERAL,
      .image = made.image,
      .subresourceRange = {made.aspect, 0, std::uint32_t(levels), 0, 1}};
  const VkDependencyInfo dependency{.sType = VK_STRUCTURE_TYPE_DEPENDENCY_INFO,
                                    .imageMemoryBarrierCount = 1,
                                    .pImageMemoryBarriers = &general};
  vkCmdPipelineBarrier2(buffer, &dependency);
  finish(buffer);
  return made;
}

inline VkBufferImageCopy whole(const Image& image) {
  return {.imageSubresource = {image.aspect, 0, 0, 1},
          .imageExtent = {std::uint32_t(image.size[0]), std::uint32_t(image.size[1]),
                          std::uint32_t(image.size[2])}};
}
inline Image image_from(VkFormat format, std::array<int, 3> size, const void* texels,
                        std::size_t bytes) {
  const Image made = image_of(format, size);
  const Buffer staging = buffer_of(bytes, VK_BUFFER_USAGE_TRANSFER_SRC_BIT, texels);
  const VkCommandBuffer buffer = begin();
  const VkBufferImageCopy region = whole(made);
  vkCmdCopyBufferToImage(buffer, staging.buffer, made.image, VK_IMAGE_LAYOUT_GENERAL, 1, &region);
  finish(buffer);
  return made;
}

inline VkSampler sampler_of(VkFilter filter, bool repeats_across, bool repeats_down) {
  const auto mode = [](bool repeats) {
    return repeats ? VK_SAMPLER_ADDRESS_MODE_REPEAT : VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE;
  };
  const VkSamplerCreateInfo asked{.sType = VK_STRUCTURE_TYPE_SAMPLER_CREATE_INFO,
                                  .magFilter = filter,
                                  .minFilter = filter,
                                  .mipmapMode = filter == VK_FILTER_LINEAR
                                                    ? VK_SAMPLER_MIPMAP_MODE_LINEAR
                                                    : VK_SAMPLER_MIPMAP_MODE_NEAREST,
                                  .addressModeU = mode(repeats_across),
                                  .addressModeV = mode(repeats_down),
                                  .addressModeW = VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE,
                                  .maxLod = VK_LOD_CLAMP_NONE};
  VkSampler made;
  check(vkCreateSampler(device, &asked, nullptr, &made), "vkCreateSampler");
  return made;
}
