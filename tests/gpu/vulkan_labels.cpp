// That a debugger such as RenderDoc sees names: every object that Vulkan is asked for gets one (descriptor sets by their
// pool's), and every pass is a labelled group. The entry points that make, name and label are replaced by ones that take note.
#include "gpu/fixture.h"
#include "gpu/vulkan/context.h"
#include "gpu/vulkan/device.h"

#include <algorithm>
#include <map>

namespace gg::gpu::vulkan {
namespace {

struct Noted {
  DeviceFunctions real;
  InstanceFunctions real_instance;
  std::map<std::uint64_t, const char*> made; // by which entry point
  std::map<std::uint64_t, std::string> names;
  std::vector<std::string> groups; // as they begin, "" as they end
};
Noted noted;

#define GG_MAKERS(F)                                                                               \
  F(AllocateMemory, VkMemoryAllocateInfo, VkDeviceMemory)                                          \
  F(CreateBuffer, VkBufferCreateInfo, VkBuffer)                                                    \
  F(CreateImage, VkImageCreateInfo, VkImage)                                                       \
  F(CreateImageView, VkImageViewCreateInfo, VkImageView)                                           \
  F(CreateSampler, VkSamplerCreateInfo, VkSampler)                                                 \
  F(CreateShaderModule, VkShaderModuleCreateInfo, VkShaderModule)                                  \
  F(CreatePipelineCache, VkPipelineCacheCreateInfo, VkPipelineCache)                               \
  F(CreatePipelineLayout, VkPipelineLayoutCreateInfo, VkPipelineLayout)                            \
  F(CreateDescriptorSetLayout, VkDescriptorSetLayoutCreateInfo, VkDescriptorSetLayout)             \
  F(CreateDescriptorPool, VkDescriptorPoolCreateInfo, VkDescriptorPool)                            \
  F(CreateSemaphore, VkSemaphoreCreateInfo, VkSemaphore)                                           \
  F(CreateQueryPool, VkQueryPoolCreateInfo, VkQueryPool)                                           \
  F(CreateCommandPool, VkCommandPoolCreateInfo, VkCommandPool)

#define GG_NOTE(NAME, INFO, HANDLE)                                                                \
  VKAPI_ATTR VkResult VKAPI_CALL note_##NAME(VkDevice device, const INFO* info,                    \
                                             const VkAllocationCallbacks* allocator, HANDLE* to) { \
    const VkResult result = noted.real.NAME(device, info, allocator, to);                          \
    if (result == VK_SUCCESS) noted.made[number_of(*to)] = #NAME;                                  \
    return result;                                                                                 \
  }
GG_MAKERS(GG_NOTE)
#undef GG_NOTE

#define GG_NOTE_PIPELINES(NAME, INFO)                                                              \
  VKAPI_ATTR VkResult VKAPI_CALL note_##NAME(                                                      \
      VkDevice device, VkPipelineCache cache, std::uint32_t count, const INFO* infos,              \
      const VkAllocationCallbacks* allocator, VkPipeline* to) {                                    \
    const VkResult result = noted.real.NAME(device, cache, count, infos, allocator, to);           \
    for (std::uint32_t i = 0; i < count; ++i)                                                      \
      noted.made[number_of(to[i])] = #NAME;                                                        \
    return result;                                                                                 \
  }
GG_NOTE_PIPELINES(CreateGraphicsPipelines, VkGraphicsPipelineCreateInfo)
GG_NOTE_PIPELINES(CreateComputePipelines, VkComputePipelineCreateInfo)
#undef GG_NOTE_PIPELINES

VKAPI_ATTR VkResult VKAPI_CALL note_command_buffers(VkDevice device,
                                                    const VkCommandBufferAllocateInfo* info,
                                                    VkCommandBuffer* to) {
  const VkResult result = noted.real.AllocateCommandBuffers(device, info, to);
  for (std::uint32_t i = 0; i < info->commandBufferCount; ++i)
    noted.made[number_of(to[i])] = "AllocateCommandBuffers";
  return result;
}
VKAPI_ATTR VkResult VKAPI_CALL note_name(VkDevice device,
                                         const VkDebugUtilsObjectNameInfoEXT* info) {
  noted.names[info->objectHandle] = info->pObjectName;
  return noted.real_instance.SetDebugUtilsObjectNameEXT(device, info);
}
VKAPI_ATTR void VKAPI_CALL note_group(VkCommandBuffer commands, const VkDebugUtilsLabelEXT* label) {
  noted.groups.push_back(label->pLabelName);
  noted.real_instance.CmdBeginDebugUtilsLabelEXT(commands, label);
}
VKAPI_ATTR void VKAPI_CALL note_group_end(VkCommandBuffer commands) {
  noted.groups.push_back("");
  noted.real_instance.CmdEndDebugUtilsLabelEXT(commands);
}

// A device that is listened to from its first object after the device itself.
std::unique_ptr<Device> listened_to() {
  auto context = std::make_shared<Context>(DeviceDesc{.backend = Backend::vulkan, .debug = true});
  noted = {};
  noted.real = context->vk();
  noted.real_instance = context->instance().functions();
  // The tables belong to this context alone and are no constants.
  auto& vk = const_cast<DeviceFunctions&>(context->vk());
  auto& instance = const_cast<InstanceFunctions&>(context->instance().functions());
#define GG_REPLACE(NAME, INFO, HANDLE) vk.NAME = note_##NAME;
  GG_MAKERS(GG_REPLACE)
#undef GG_REPLACE
  vk.CreateGraphicsPipelines = note_CreateGraphicsPipelines;
  vk.CreateComputePipelines = note_CreateComputePipelines;
  vk.AllocateCommandBuffers = note_command_buffers;
  instance.SetDebugUtilsObjectNameEXT = note_name;
  instance.CmdBeginDebugUtilsLabelEXT = note_group;
  instance.CmdEndDebugUtilsLabelEXT = note_group_end;
  return std::make_unique<VulkanDevice>(std::move(context));
}

TEST(vulkan_labels, are_on_every_object_and_around_every_pass) {
  const auto device = listened_to();
  const std::vector<FlatVertex> triangle(3);
  const auto vertices = device->create(
      BufferDesc{"the triangle", triangle.size() * sizeof(FlatVertex), Use::vertices},
      bytes_of(triangle));
  const auto color =
      device->create(TextureDesc{.label = "the picture",
                                 .width = 8,
                                 .height = 8,
                                 .levels = 2,
                                 .use = Use::attachment | Use::sampled | Use::read_back});
  const std::vector<std::uint32_t> zeros(64); // of Settings: nothing is to be squared
  const auto settings = device->create(BufferDesc{"settings", 256, Use::uniforms}, bytes_of(zeros));
  const auto given = device->create(BufferDesc{"numbers", 256, Use::storage});
  const auto squares = device->create(BufferDesc{"squares", 256, Use::storage | Use::read_back});
  const auto sampler = device->create(SamplerDesc{.u = Wrap::repeat});
  const auto flat = device->create(flat_pipeline(Format::rgba8));
  const auto square = device->create(ComputeDesc{"squaring", stage("square.comp"), {}});
  const std::vector<Pass> passes = {
      {.label = "first, drawing",
       .colors = {{.view = {color}, .clear = {{0, 0, 0, 1}}}},
       .record =
           [&](Encoder& encoder) {
             encoder.use(flat);
             encoder.vertices(0, vertices);
             encoder.draw(3);
           }},
      {.label = "second, computing",
       .writes_buffers = {squares},
       .record =
           [&](Encoder& encoder) {
             encoder.use(square);
             encoder.buffer("Settings", settings);
             encoder.buffer("Input", given);
             encoder.buffer("Output", squares);
             encoder.dispatch(1, 1, 1);
           }},
  };
  std::vector<PassTime> times;
  device->run(passes, &times);
  device->generate_mipmaps(color);
  device->read(color, 0, 0);

  EXPECT_GE(noted.made.size(), 15u);
  for (const auto& [handle, maker] : noted.made)
    EXPECT_FALSE(noted.names[handle].empty()) << "an object made by vk" << maker << " has no name";
  for (const char* label : {"the triangle", "the picture", "numbers", "squaring", "timers"})
    EXPECT_TRUE(std::ranges::any_of(noted.names, [&](const auto& named) {
      return named.second == label;
    })) << label;
  std::vector<std::string> own;
  int depth = 0;
  for (const std::string& group : noted.groups) {
    depth += group.empty() ? -1 : 1;
    EXPECT_GE(depth, 0);
    if (group == "first, drawing" || group == "second, computing") own.push_back(group);
  }
  EXPECT_EQ(depth, 0);
  EXPECT_EQ(own, (std::vector<std::string>{"first, drawing", "second, computing"}));
}

} // namespace
} // namespace gg::gpu::vulkan
