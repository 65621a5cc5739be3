#include "gpu/vulkan/pipeline.h"

#include "gpu/vulkan/formats.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace gg::gpu::vulkan {

namespace {

using shaders::Stage;

VkShaderStageFlagBits stage_bit(Stage stage) {
  switch (stage) {
  case Stage::vertex:
    return VK_SHADER_STAGE_VERTEX_BIT;
  case Stage::fragment:
    return VK_SHADER_STAGE_FRAGMENT_BIT;
  case Stage::compute:
    return VK_SHADER_STAGE_COMPUTE_BIT;
  }
  return VK_SHADER_STAGE_ALL;
}

[[noreturn]] void refuse(const std::string& label, const std::string& what) {
  throw Error(ExitCode::internal, "pipeline '" + label + "'", what);
}

// The vertex inputs that the stage reads, laid out as the description says.
std::vector<VkVertexInputAttributeDescription> attributes_of(const PipelineDesc& desc,
                                                             const shaders::Reflection& vertex) {
  std::vector<VkVertexInputAttributeDescription> attributes;
  for (const shaders::Varying& input : vertex.inputs) {
    const auto attribute =
        std::find_if(desc.attributes.begin(), desc.attributes.end(), [&](const Attribute& a) {
          return a.location == static_cast<int>(input.location);
        });
    if (attribute == desc.attributes.end())
      refuse(desc.label, fmt::format("nothing feeds the vertex input {} at location {}", input.name,
                                     input.location));
    attributes.push_back({.location = input.location,
                          .binding = static_cast<std::uint32_t>(attribute->binding),
                          .format = attribute_format(attribute->components),
                          .offset = attribute->offset});
  }
  return attributes;
}

} // namespace

// The modules of a pipeline while it is being made.
struct GpuPipeline::Stages {
  Stages(Context& owner, const shaders::Program& program) : context(owner) {
    try {
      for (const shaders::Module& module : program.modules)
        add(module);
    } catch (...) {
      clear();
      throw;
    }
  }
  ~Stages() { clear(); }
  Stages(const Stages&) = delete;
  Stages& operator=(const Stages&) = delete;

  void add(const shaders::Module& module) {
    const VkShaderModuleCreateInfo info{.sType = VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO,
                                        .codeSize = module.words.size() * sizeof(std::uint32_t),
                                        .pCode = module.words.data()};
    VkShaderModule made = VK_NULL_HANDLE;
    check(context.vk().CreateShaderModule(context.device(), &info, nullptr, &made),
          ("compiling " + module.name).c_str());
    stages.push_back({.sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO,
                      .stage = stage_bit(module.stage),
                      .module = made,
                      .pName = "main"});
    context.name(VK_OBJECT_TYPE_SHADER_MODULE, made, module.name);
    ++context.counters.compiled;
  }
  void clear() {
    for (const auto& stage : stages)
      context.vk().DestroyShaderModule(context.device(), stage.module, nullptr);
  }

  Context& context;
  std::vector<VkPipelineShaderStageCreateInfo> stages;
};

shaders::Program GpuPipeline::link(const PipelineKit& kit, std::span<const std::string> stages,
                                   std::span<const Constant> constants) {
  shaders::Program program = shaders::link(label, stages, constants, Backend::vulkan);
  const auto is = [&](std::size_t i, Stage stage) { return program.modules[i].stage == stage; };
  if (stages.size() == 2 ? !is(0, Stage::vertex) || !is(1, Stage::fragment)
                         : !is(0, Stage::compute))
    refuse(label, "needs a .vert and a .frag stage to draw, or a .comp stage to compute");

  VkShaderStageFlags flags = 0;
  for (const shaders::Module& module : program.modules)
    flags |= stage_bit(module.stage);
  layout = &kit.layouts.find_or_make(program.bindings, flags);
  for (const shaders::Binding& binding : program.bindings)
    slots.push_back({kit.names.add(binding.name), binding.binding, binding});
  std::sort(slots.begin(), slots.end(),
            [](const Slot& a, const Slot& b) { return a.binding.binding < b.binding.binding; });
  return program;
}

GpuPipeline::GpuPipeline(const PipelineKit& kit, const ComputeDesc& desc) : context(kit.context) {
  label = desc.label;
  const shaders::Program program = link(kit, std::array{desc.compute}, desc.constants);
  const Stages stages(*context, program);
  const VkComputePipelineCreateInfo info{.sType = VK_STRUCTURE_TYPE_COMPUTE_PIPELINE_CREATE_INFO,
                                         .stage = stages.stages[0],
                                         .layout = layout->pipeline};
  if (const auto result = context->vk().CreateComputePipelines(
          context->device(), kit.cache.handle(), 1, &info, nullptr, &handle))
    throw error_of(result, "compiling the pipeline '" + label + "'");
  context->name(VK_OBJECT_TYPE_PIPELINE, handle, label);
  ++context->counters.created, ++context->counters.compiled;
}

GpuPipeline::GpuPipeline(const PipelineKit& kit, const PipelineDesc& desc) : context(kit.context) {
  drawing = desc;
  label = desc.label;
  const shaders::Program program =
      link(kit, std::array{desc.vertex, desc.fragment}, desc.constants);
  const Stages stages(*context, program);

  std::vector<VkVertexInputBindingDescription> bindings;
  for (std::size_t i = 0; i < desc.bindings.size(); ++i)
    bindings.push_back({.binding = static_cast<std::uint32_t>(i),
                        .stride = desc.bindings[i].stride,
                        .inputRate = desc.bindings[i].step == Step::instance
                                         ? VK_VERTEX_INPUT_RATE_INSTANCE
                                         : VK_VERTEX_INPUT_RATE_VERTEX});
  const auto attributes = attributes_of(desc, program.reflections[0]);
  const VkPipelineVertexInputStateCreateInfo input{
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
      .sType = VK_STRUCTURE_TYPE_PIPELINE_RASTERIZATION_STATE_CREATE_INFO,
      .polygonMode = VK_POLYGON_MODE_FILL,
      .lineWidth = 1.0f};
  const VkPipelineMultisampleStateCreateInfo samples{
      .sType = VK_STRUCTURE_TYPE_PIPELINE_MULTISAMPLE_STATE_CREATE_INFO,
      .rasterizationSamples = VK_SAMPLE_COUNT_1_BIT};
  const VkPipelineDepthStencilStateCreateInfo depth{
      .sType = VK_STRUCTURE_TYPE_PIPELINE_DEPTH_STENCIL_STATE_CREATE_INFO,
      .depthTestEnable = desc.depth != Format::none,
      .depthWriteEnable = desc.depth != Format::none && desc.depth_write,
      .depthCompareOp = compare_of(desc.depth_compare)};
  std::vector<VkPipelineColorBlendAttachmentState> blends;
  std::vector<VkFormat> formats;
  for (const Format color : desc.colors) {
    blends.push_back(blend_of(desc.blend, color));
    formats.push_back(format_of(color));
  }
  const VkPipelineColorBlendStateCreateInfo blend{
      .sType = VK_STRUCTURE_TYPE_PIPELINE_COLOR_BLEND_STATE_CREATE_INFO,
      .attachmentCount = static_cast<std::uint32_t>(blends.size()),
      .pAttachments = blends.data()};
  constexpr std::array dynamics{VK_DYNAMIC_STATE_VIEWPORT, VK_DYNAMIC_STATE_SCISSOR,
                                VK_DYNAMIC_STATE_CULL_MODE, VK_DYNAMIC_STATE_FRONT_FACE};
  const VkPipelineDynamicStateCreateInfo dynamic{
      .sType = VK_STRUCTURE_TYPE_PIPELINE_DYNAMIC_STATE_CREATE_INFO,
      .dynamicStateCount = dynamics.size(),
      .pDynamicStates = dynamics.data()};
  const VkPipelineRenderingCreateInfo targets{
      .sType = VK_STRUCTURE_TYPE_PIPELINE_RENDERING_CREATE_INFO,
      .colorAttachmentCount = static_cast<std::uint32_t>(formats.size()),
      .pColorAttachmentFormats = formats.data(),
      .depthAttachmentFormat = format_of(desc.depth)};
  const VkGraphicsPipelineCreateInfo info{.sType = VK_STRUCTURE_TYPE_GRAPHICS_PIPELINE_CREATE_INFO,
                                          .pNext = &targets,
                                          .stageCount =
                                              static_cast<std::uint32_t>(stages.stages.size()),
                                          .pStages = stages.stages.data(),
                                          .pVertexInputState = &input,
                                          .pInputAssemblyState = &assembly,
                                          .pViewportState = &viewport,
                                          .pRasterizationState = &raster,
                                          .pMultisampleState = &samples,
                                          .pDepthStencilState = &depth,
                                          .pColorBlendState = &blend,
                                          .pDynamicState = &dynamic,
                                          .layout = layout->pipeline};
  if (const auto result = context->vk().CreateGraphicsPipelines(
          context->device(), kit.cache.handle(), 1, &info, nullptr, &handle))
    throw error_of(result, "compiling the pipeline '" + label + "'");
  context->name(VK_OBJECT_TYPE_PIPELINE, handle, label);
  ++context->counters.created, ++context->counters.compiled;
}

GpuPipeline::~GpuPipeline() {
  context->retire([&shared = *context, pipeline = handle] {
    shared.vk().DestroyPipeline(shared.device(), pipeline, nullptr);
  });
}

} // namespace gg::gpu::vulkan
