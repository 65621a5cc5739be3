// Instructions and registers of every fragment shader of a frame, compiled for RDNA2 by Mesa's driver; no GPU is needed.
//
//   RADV_FORCE_FAMILY=navi21 VK_ICD_FILENAMES=/usr/share/vulkan/icd.d/radeon_icd.x86_64.json shader_cost SCENE...
//
// The driver then offers a device that compiles and runs nothing, and tells what it compiled by
// VK_KHR_pipeline_executable_properties. A loop counts once.
#include "gpu/shaders/compile.h"
#include "scene/load.h"
#include "support/scene_pipelines.h"

#include <fmt/format.h>
#include <vulkan/vulkan.h>

#include <array>
#include <cstdio>
#include <cstring>
#include <exception>
#include <map>
#include <set>
#include <stdexcept>

namespace {

using namespace gg;

void check(VkResult result, const char* what) {
  if (result != VK_SUCCESS)
    throw std::runtime_error(fmt::format("{}: VkResult {}", what, static_cast<int>(result)));
}

template <class F>
F function(VkDevice device, const char* name) {
  return reinterpret_cast<F>(vkGetDeviceProcAddr(device, name));
}

VkDevice create_device() {
  const VkApplicationInfo application{.sType = VK_STRUCTURE_TYPE_APPLICATION_INFO,
                                      .apiVersion = VK_API_VERSION_1_3};
  const VkInstanceCreateInfo instance_info{.sType = VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO,
                                           .pApplicationInfo = &application};
  VkInstance instance = VK_NULL_HANDLE;
  check(vkCreateInstance(&instance_info, nullptr, &instance), "vkCreateInstance");
  std::uint32_t count = 1;
  VkPhysicalDevice physical = VK_NULL_HANDLE;
  vkEnumeratePhysicalDevices(instance, &count, &physical);
  if (count == 0) throw std::runtime_error("no Vulkan device: see the first lines of this file");
  const float priority = 1.0f;
  const VkDeviceQueueCreateInfo queue{.sType = VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO,
                                      .queueCount = 1,
                                      .pQueuePriorities = &priority};
  VkPhysicalDevicePipelineExecutablePropertiesFeaturesKHR executables{
      .sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PIPELINE_EXECUTABLE_PROPERTIES_FEATURES_KHR,
      .pipelineExecutableInfo = VK_TRUE};
  VkPhysicalDeviceVulkan13Features features{
      .sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_3_FEATURES,
      .pNext = &executables,
      .dynamicRendering = VK_TRUE};
  const char* extension = VK_KHR_PIPELINE_EXECUTABLE_PROPERTIES_EXTENSION_NAME;
  const VkDeviceCreateInfo info{.sType = VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO,
                                .pNext = &features,
                                .queueCreateInfoCount = 1,
                                .pQueueCreateInfos = &queue,
                                .enabledExtensionCount = 1,
                                .ppEnabledExtensionNames = &extension};
  VkDevice device = VK_NULL_HANDLE;
  check(vkCreateDevice(physical, &info, nullptr, &device), "vkCreateDevice");
  return device;
}

VkDescriptorType type_of(gpu::shaders::Kind kind) {
  switch (kind) {
  case gpu::shaders::Kind::uniform_block:
    return VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER;
  case gpu::shaders::Kind::storage_block:
    return VK_DESCRIPTOR_TYPE_STORAGE_BUFFER;
  case gpu::shaders::Kind::sampled:
    return VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER;
  case gpu::shaders::Kind::image:
    return VK_DESCRIPTOR_TYPE_STORAGE_IMAGE;
  }
  return VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER;
}

VkPipelineLayout layout_of(VkDevice device, const gpu::shaders::Program& program) {
  std::vector<VkDescriptorSetLayoutBinding> bindings;
  for (const gpu::shaders::Binding& binding : program.bindings)
    bindings.push_back({.binding = binding.binding,
                        .descriptorType = type_of(binding.kind),
                        .descriptorCount = 1,
                        .stageFlags = VK_SHADER_STAGE_ALL_GRAPHICS});
  const VkDescriptorSetLayoutCreateInfo set_info{
      .sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO,
      .bindingCount = static_cast<std::uint32_t>(bindings.size()),
      .pBindings = bindings.data()};
  VkDescriptorSetLayout set = VK_NULL_HANDLE;
  check(vkCreateDescriptorSetLayout(device, &set_info, nullptr, &set), "descriptor set layout");
  const VkPipelineLayoutCreateInfo info{.sType = VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO,
                                        .setLayoutCount = 1,
                                        .pSetLayouts = &set};
  VkPipelineLayout layout = VK_NULL_HANDLE;
  check(vkCreatePipelineLayout(device, &info, nullptr, &layout), "pipeline layout");
  return layout;
}

// Formats of targets change a shader's last instructions alone: all are taken for floats of 32 bits.
VkPipeline compile(VkDevice device, const gpu::PipelineDesc& desc,
                   const gpu::shaders::Program& program) {
  std::vector<VkPipelineShaderStageCreateInfo> stages;
  for (const gpu::shaders::Module& module : program.modules) {
    const VkShaderModuleCreateInfo info{.sType = VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO,
                                        .codeSize = 4 * module.words.size(),
                                        .pCode = module.words.data()};
    const bool vertex = module.stage == gpu::shaders::Stage::vertex;
    stages.push_back({.sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO,
                      .stage = vertex ? VK_SHADER_STAGE_VERTEX_BIT : VK_SHADER_STAGE_FRAGMENT_BIT,
                      .pName = "main"});
    check(vkCreateShaderModule(device, &info, nullptr, &stages.back().module), "shader module");
  }
  std::vector<VkVertexInputBindingDescription> bindings;
  std::vector<VkVertexInputAttributeDescription> attributes;
  for (std::uint32_t i = 0; i < desc.bindings.size(); ++i)
    bindings.push_back({i, desc.bindings[i].stride, VK_VERTEX_INPUT_RATE_VERTEX});
  for (const gpu::Attribute& a : desc.attributes)
    attributes.push_back({static_cast<std::uint32_t>(a.location),
                          static_cast<std::uint32_t>(a.binding), VK_FORMAT_R32G32B32A32_SFLOAT,
                          a.offset});
  const VkPipelineVertexInputStateCreateInfo vertices{
      .sType = VK_STRUCTURE_TYPE_PIPELINE_VERTEX_INPUT_STATE_CREATE_INFO,
      .vertexBindingDescriptionCount = static_cast<std::uint32_t>(bindings.size()),
      .pVertexBindingDescriptions = bindings.data(),
      .vertexAttributeDescriptionCount = static_cast<std::uint32_t>(attributes.size()),
      .pVertexAttributeDescriptions = attributes.data()};
  const VkPipelineInputAssemblyStateCreateInfo assembly{
      .sType = VK_STRUCTURE_TYPE_PIPELINE_INPUT_ASSEMBLY_STATE_CREATE_INFO,
      .topology = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST};
  const VkPipelineViewportStateCreateInfo viewport{
      .sType = VK_STRUCTURE_TYPE_PIPELINE_VIEWPORT_STATE_CREATE_INFO,
      .viewportCount = 1,
      .scissorCount = 1};
  const VkPipelineRasterizationStateCreateInfo raster{
      .sType = VK_STRUCTURE_TYPE_PIPELINE_RASTERIZATION_STATE_CREATE_INFO, .lineWidth = 1.0f};
  const VkPipelineMultisampleStateCreateInfo samples{
      .sType = VK_STRUCTURE_TYPE_PIPELINE_MULTISAMPLE_STATE_CREATE_INFO,
      .rasterizationSamples = VK_SAMPLE_COUNT_1_BIT};
  const VkPipelineDepthStencilStateCreateInfo depth{
      .sType = VK_STRUCTURE_TYPE_PIPELINE_DEPTH_STENCIL_STATE_CREATE_INFO,
      .depthTestEnable = VK_TRUE,
      .depthWriteEnable = desc.depth_write ? VK_TRUE : VK_FALSE,
      .depthCompareOp = VK_COMPARE_OP_GREATER_OR_EQUAL};
  const std::vector<VkFormat> formats(desc.colors.size(), VK_FORMAT_R32G32B32A32_SFLOAT);
  const std::vector<VkPipelineColorBlendAttachmentState> blends(desc.colors.size(),
                                                                {.colorWriteMask = 15});
  const VkPipelineColorBlendStateCreateInfo blend{
      .sType = VK_STRUCTURE_TYPE_PIPELINE_COLOR_BLEND_STATE_CREATE_INFO,
      .attachmentCount = static_cast<std::uint32_t>(blends.size()),
      .pAttachments = blends.data()};
  const std::array states{VK_DYNAMIC_STATE_VIEWPORT, VK_DYNAMIC_STATE_SCISSOR};
  const VkPipelineDynamicStateCreateInfo dynamic{
      .sType = VK_STRUCTURE_TYPE_PIPELINE_DYNAMIC_STATE_CREATE_INFO,
      .dynamicStateCount = states.size(),
      .pDynamicStates = states.data()};
  const VkPipelineRenderingCreateInfo rendering{
      .sType = VK_STRUCTURE_TYPE_PIPELINE_RENDERING_CREATE_INFO,
      .colorAttachmentCount = static_cast<std::uint32_t>(formats.size()),
      .pColorAttachmentFormats = formats.data(),
      .depthAttachmentFormat = VK_FORMAT_D32_SFLOAT};
  const VkGraphicsPipelineCreateInfo info{.sType = VK_STRUCTURE_TYPE_GRAPHICS_PIPELINE_CREATE_INFO,
                                          .pNext = &rendering,
                                          .flags = VK_PIPELINE_CREATE_CAPTURE_STATISTICS_BIT_KHR,
                                          .stageCount = static_cast<std::uint32_t>(stages.size()),
                                          .pStages = stages.data(),
                                          .pVertexInputState = &vertices,
                                          .pInputAssemblyState = &assembly,
                                          .pViewportState = &viewport,
                                          .pRasterizationState = &raster,
                                          .pMultisampleState = &samples,
                                          .pDepthStencilState = &depth,
                                          .pColorBlendState = &blend,
                                          .pDynamicState = &dynamic,
                                          .layout = layout_of(device, program)};
  VkPipeline pipeline = VK_NULL_HANDLE;
  check(vkCreateGraphicsPipelines(device, VK_NULL_HANDLE, 1, &info, nullptr, &pipeline),
        "pipeline");
  return pipeline;
}

using Statistics = std::map<std::string, std::uint64_t>;

Statistics statistics_of(VkDevice device, VkPipeline pipeline) {
  const auto properties = function<PFN_vkGetPipelineExecutablePropertiesKHR>(
      device, "vkGetPipelineExecutablePropertiesKHR");
  const auto statistics = function<PFN_vkGetPipelineExecutableStatisticsKHR>(
      device, "vkGetPipelineExecutableStatisticsKHR");
  const VkPipelineInfoKHR of{.sType = VK_STRUCTURE_TYPE_PIPELINE_INFO_KHR, .pipeline = pipeline};
  std::uint32_t count = 0;
  check(properties(device, &of, &count, nullptr), "executables");
  std::vector<VkPipelineExecutablePropertiesKHR> executables(
      count, {.sType = VK_STRUCTURE_TYPE_PIPELINE_EXECUTABLE_PROPERTIES_KHR});
  check(properties(device, &of, &count, executables.data()), "executables");
  Statistics result;
  for (std::uint32_t e = 0; e < count; ++e) {
    if (!(executables[e].stages & VK_SHADER_STAGE_FRAGMENT_BIT)) continue;
    const VkPipelineExecutableInfoKHR which{.sType = VK_STRUCTURE_TYPE_PIPELINE_EXECUTABLE_INFO_KHR,
                                            .pipeline = pipeline,
                                            .executableIndex = e};
    std::uint32_t values = 0;
    check(statistics(device, &which, &values, nullptr), "statistics");
    std::vector<VkPipelineExecutableStatisticKHR> list(
        values, {.sType = VK_STRUCTURE_TYPE_PIPELINE_EXECUTABLE_STATISTIC_KHR});
    check(statistics(device, &which, &values, list.data()), "statistics");
    for (const VkPipelineExecutableStatisticKHR& s : list)
      if (s.format == VK_PIPELINE_EXECUTABLE_STATISTIC_FORMAT_UINT64_KHR)
        result[s.name] = s.value.u64;
  }
  return result;
}

void print_costs(VkDevice device, const char* file) {
  const scene::Scene scene = scene::load(file);
  fmt::print("{}\n{:32} {:>12} {:>6} {:>8}\n", file, "fragment stage", "instructions", "VGPRs",
             "spilled");
  std::set<std::pair<std::string, std::uint64_t>> printed; // variants of one cost once
  for (const gpu::PipelineDesc& desc : test::pipelines_of(scene, needs::Method::lobes2)) {
    const std::array stages{desc.vertex, desc.fragment};
    const auto program =
        gpu::shaders::link(desc.label, stages, desc.constants, gpu::Backend::vulkan);
    Statistics cost = statistics_of(device, compile(device, desc, program));
    if (printed.emplace(desc.fragment, cost["Instructions"]).second)
      fmt::print("{:32} {:12} {:6} {:8}\n", desc.fragment, cost["Instructions"], cost["VGPRs"],
                 cost["Spilled VGPRs"]);
  }
}

} // namespace

int main(int argc, char** argv) {
  try {
    gpu::shaders::keep_modules();
    VkDevice device = create_device();
    for (int i = 1; i < argc; ++i)
      print_costs(device, argv[i]);
  } catch (const std::exception& error) {
    fmt::print(stderr, "shader_cost: {}\n", error.what());
    return 1;
  }
  return 0;
}
