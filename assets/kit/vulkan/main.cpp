// Rough glass in Vulkan 1.3, offscreen: README.md beside this file says what each pass is.
//   rough_glass [SCENE.glb [ENVIRONMENT.hdr [OUT [WIDTH HEIGHT [SAMPLES [TIER]]]]]]
#include "device.h"

namespace {

struct Texture {
  VkImageView view;
  VkSampler sampler;
};
struct Body {
  const Mesh* mesh;
  Buffer vertices, indices;
  VkDescriptorSet set;
};

// One layer of faces of glass: the nearest back faces, the front faces behind those, the back faces behind these.
struct FaceLayer {
  VkPipeline pipeline;
  Image image;
};

class Renderer {
public:
  Renderer(const Scene& scene, const Environment& map, int width, int height, bool pairs)
      : scene_(scene), width_(width), height_(height), last_(last_level_of(width, height)) {
    linear_ = sampler_of(VK_FILTER_LINEAR, false, false);
    nearest_ = sampler_of(VK_FILTER_NEAREST, false, false);
    make_layout();
    const VkFormat half = VK_FORMAT_R16G16B16A16_SFLOAT, depth = VK_FORMAT_D32_SFLOAT,
                   full = VK_FORMAT_R32G32B32A32_SFLOAT;
    sky_ = pipeline_of("fullscreen.vert", "sky.frag", half, true, false, VK_CULL_MODE_NONE);
    body_ = pipeline_of("mesh.vert", "body.frag", half, true, true, VK_CULL_MODE_NONE);
    glass_ =
        pipeline_of("mesh.vert", pairs ? "glass_pairs.frag" : "glass.frag", half, true, true,
                    VK_CULL_MODE_BACK_BIT); // closed: what faces away is seen through their front
    halve_ = pipeline_of("fullscreen.vert", "halve.frag", half, false, false, VK_CULL_MODE_NONE);
    blocks_ = buffer_of(aligned(sizeof(FrameBlock)) + aligned(sizeof(DrawBlock)) * most_draws,
                        VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT);
    const std::array<int, 3> size{width, height, 1};
    pyramid_ = image_of(half, size, last_ + 1);
    depth_ = image_of(depth, size);
    face_depth_ = image_of(depth, size);
    const char* const layers[] = {"back_faces.frag", "second_fronts.frag", "second_backs.frag"};
    for (int k = 0; k < (pairs ? 3 : 1); ++k)
      faces_.push_back({pipeline_of("mesh.vert", layers[k], full, true, true,
                                    k == 1 ? VK_CULL_MODE_BACK_BIT : VK_CULL_MODE_FRONT_BIT),
                        image_of(full, size)});
    frame_ = image_of(half, size);
    frame_depth_ = image_of(depth, size);
    for (int k = 0; k < 2; ++k)
      atlas_[k] = image_of(half, {environment_.width, environment_.height[k], 1});
    const auto tables = tables_of(".");
    for (int k = 0; k < 3; ++k)
      textures_[ENERGY + k] = {
          image_from(half, tables[k].size, tables[k].halves.data(), tables[k].halves.size()).all,
          linear_};
    textures_[PYRAMID] = {pyramid_.all, linear_};
    textures_[DEPTH] = {depth_.all, nearest_};
    textures_[EVEN] = {atlas_[0].all, linear_};
    textures_[ODD] = {atlas_[1].all, linear_};
    for (std::size_t k = 0; k < 3; ++k) // what a tier does not draw it does not read
      textures_[BACKS + k] = {faces_[std::min(k, faces_.size() - 1)].image.all, nearest_};
    const Texture none = textures_[BACKS]; // where a pass reads nothing
    nothing_ = set_of(none, none);
    for (const Mesh& mesh : scene.meshes)
      bodies_.push_back(body_of(mesh));
    for (int k = 0; k < last_; ++k)
      level_sets_.push_back(set_of({pyramid_.level[k], linear_}, none));
    read_ = buffer_of(8U * width * height, VK_BUFFER_USAGE_TRANSFER_DST_BIT);
    blur_environment(map);
  }

  // Linear radiance, RGBA, the top row first. offset, samples: see frame_of.
  std::vector<float> draw(glm::vec2 offset, int samples) {
    const FrameBlock frame =
        frame_of(scene_, environment_, width_, height_, offset, samples, last_, false);
    std::memcpy(blocks_.data, &frame, sizeof frame);
    draws_ = 0;
    buffer_ = begin();
    draw_bodies();                     // 1. what is not glass, with its depth
    for (int k = 1; k <= last_; ++k) { // 2. its pyramid of Gaussians
      const glm::vec4 source(std::max(1, width_ >> (k - 1)), std::max(1, height_ >> (k - 1)), 0.0F,
                             0.0F);
      run(halve_, pyramid_.level[k], {0, 0, std::max(1, width_ >> k), std::max(1, height_ >> k)},
          level_sets_[k - 1], {source, {}});
    }
    for (const FaceLayer& layer : faces_) { // 3. where rays leave the glass
      open_pass(layer.image.level[0], face_depth_.level[0], {0, 0, width_, height_}, true);
      draw_meshes(layer.pipeline, true);
      vkCmdEndRendering(buffer_);
    }
    draw_glass(); // 4. glass, over what is not
    wait(buffer_);
    const VkBufferImageCopy region = whole(frame_);
    vkCmdCopyImageToBuffer(buffer_, frame_.image, VK_IMAGE_LAYOUT_GENERAL, read_.buffer, 1,
                           &region);
    wait(buffer_);
    finish(buffer_);
    std::vector<float> texels(4U * width_ * height_);
    const auto* const halves = reinterpret_cast<const std::uint16_t*>(read_.data);
    for (std::size_t i = 0; i < texels.size(); ++i)
      texels[i] = glm::unpackHalf2x16(halves[i]).x;
    return texels;
  }

private:
  static constexpr std::size_t most_draws = 4096;

  // Blocks begin at multiples of what the device asks for; the second block each draw has at an offset of its own.
  static std::size_t aligned(std::size_t bytes) {
    const std::size_t step = properties.limits.minUniformBufferOffsetAlignment;
    return (bytes + step - 1) / step * step;
  }

  void make_layout() {
    VkDescriptorSetLayoutBinding bindings[BINDINGS];
    for (std::uint32_t k = 0; k < BINDINGS; ++k)
      bindings[k] = {k,
                     k == FRAME  ? VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER
                     : k == DRAW ? VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER_DYNAMIC
                                 : VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER,
                     1, VK_SHADER_STAGE_VERTEX_BIT | VK_SHADER_STAGE_FRAGMENT_BIT, nullptr};
    const VkDescriptorSetLayoutCreateInfo one{
        .sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO,
        .bindingCount = BINDINGS,
        .pBindings = bindings};
    check(vkCreateDescriptorSetLayout(device, &one, nullptr, &set_layout_),
          "vkCreateDescriptorSetLayout");
    const VkPipelineLayoutCreateInfo all{.sType = VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO,
                                         .setLayoutCount = 1,
                                         .pSetLayouts = &set_layout_};
    check(vkCreatePipelineLayout(device, &all, nullptr, &layout_), "vkCreatePipelineLayout");
    const std::uint32_t sets = std::uint32_t(scene_.meshes.size()) + 64;
    const VkDescriptorPoolSize sizes[] = {
        {VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER, sets},
        {VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER_DYNAMIC, sets},
        {VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, sets * BINDINGS}};
    const VkDescriptorPoolCreateInfo pool{.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO,
                                          .maxSets = sets,
                                          .poolSizeCount = 3,
                                          .pPoolSizes = sizes};
    check(vkCreateDescriptorPool(device, &pool, nullptr, &pool_), "vkCreateDescriptorPool");
  }

  VkDescriptorSet set_of(Texture color, Texture roughness) {
    const VkDescriptorSetAllocateInfo asked{.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO,
                                            .descriptorPool = pool_,
                                            .descriptorSetCount = 1,
                                            .pSetLayouts = &set_layout_};
    VkDescriptorSet set;
    check(vkAllocateDescriptorSets(device, &asked, &set), "vkAllocateDescriptorSets");
    const VkDescriptorBufferInfo blocks[] = {{blocks_.buffer, 0, sizeof(FrameBlock)},
                                             {blocks_.buffer, 0, sizeof(DrawBlock)}};
    VkDescriptorImageInfo images[BINDINGS];
    VkWriteDescriptorSet writes[BINDINGS];
    for (std::uint32_t k = 0; k < BINDINGS; ++k) {
      const Texture& t = k == COLOR ? color : k == ROUGHNESS ? roughness : textures_[k];
      images[k] = {t.sampler, t.view, VK_IMAGE_LAYOUT_GENERAL};
      writes[k] = {.sType = VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET,
                   .dstSet = set,
                   .dstBinding = k,
                   .descriptorCount = 1,
                   .descriptorType = k == FRAME  ? VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER
                                     : k == DRAW ? VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER_DYNAMIC
                                                 : VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER,
                   .pImageInfo = &images[k],
                   .pBufferInfo = k < COLOR ? &blocks[k] : nullptr};
    }
    vkUpdateDescriptorSets(device, BINDINGS, writes, 0, nullptr);
    return set;
  }

  VkPipeline pipeline_of(const std::string& vertex, const std::string& fragment, VkFormat format,
                         bool depth, bool meshes, VkCullModeFlags cull) {
    VkPipelineShaderStageCreateInfo stages[2];
    for (int k = 0; k < 2; ++k) {
      const std::string words = bytes_of("shaders/" + (k == 0 ? vertex : fragment) + ".spv");
      const VkShaderModuleCreateInfo asked{
          .sType = VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO,
          .codeSize = words.size(),
          .pCode = reinterpret_cast<const std::uint32_t*>(words.data())};
      VkShaderModule module;
      check(vkCreateShaderModule(device, &asked, nullptr, &module), "vkCreateShaderModule");
      stages[k] = {.sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO,
                   .stage = k == 0 ? VK_SHADER_STAGE_VERTEX_BIT : VK_SHADER_STAGE_FRAGMENT_BIT,
                   .module = module,
                   .pName = "main"};
    }
    const VkVertexInputBindingDescription stream{0, sizeof(Vertex), VK_VERTEX_INPUT_RATE_VERTEX};
    const VkVertexInputAttributeDescription attributes[] = {
        {0, 0, VK_FORMAT_R32G32B32_SFLOAT, offsetof(Vertex, position)},
        {1, 0, VK_FORMAT_R32G32B32_SFLOAT, offsetof(Vertex, normal)},
        {2, 0, VK_FORMAT_R32G32_SFLOAT, offsetof(Vertex, uv)}};
    const VkPipelineVertexInputStateCreateInfo input{
        .sType = VK_STRUCTURE_TYPE_PIPELINE_VERTEX_INPUT_STATE_CREATE_INFO,
        .vertexBindingDescriptionCount = meshes ? 1U : 0U,
        .pVertexBindingDescriptions = &stream,
        .vertexAttributeDescriptionCount = meshes ? 3U : 0U,
        .pVertexAttributeDescriptions = attributes};
    const VkPipelineInputAssemblyStateCreateInfo assembly{
        .sType = VK_STRUCTURE_TYPE_PIPELINE_INPUT_ASSEMBLY_STATE_CREATE_INFO,
        .topology = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST};
    const VkPipelineViewportStateCreateInfo view{
        .sType = VK_STRUCTURE_TYPE_PIPELINE_VIEWPORT_STATE_CREATE_INFO,
        .viewportCount = 1,
        .scissorCount = 1};
    const VkPipelineRasterizationStateCreateInfo raster{
        .sType = VK_STRUCTURE_TYPE_PIPELINE_RASTERIZATION_STATE_CREATE_INFO,
        .cullMode = cull,
        .frontFace = VK_FRONT_FACE_COUNTER_CLOCKWISE,
        .lineWidth = 1.0F};
    const VkPipelineMultisampleStateCreateInfo single{
        .sType = VK_STRUCTURE_TYPE_PIPELINE_MULTISAMPLE_STATE_CREATE_INFO,
        .rasterizationSamples = VK_SAMPLE_COUNT_1_BIT};
    const VkPipelineDepthStencilStateCreateInfo tested{
        .sType = VK_STRUCTURE_TYPE_PIPELINE_DEPTH_STENCIL_STATE_CREATE_INFO,
        .depthTestEnable = depth,
        .depthWriteEnable = meshes,
        .depthCompareOp = VK_COMPARE_OP_LESS_OR_EQUAL};
    const VkPipelineColorBlendAttachmentState plain{.colorWriteMask = 15};
    const VkPipelineColorBlendStateCreateInfo blend{
        .sType = VK_STRUCTURE_TYPE_PIPELINE_COLOR_BLEND_STATE_CREATE_INFO,
        .attachmentCount = 1,
        .pAttachments = &plain};
    const VkDynamicState states[] = {VK_DYNAMIC_STATE_VIEWPORT, VK_DYNAMIC_STATE_SCISSOR};
    const VkPipelineDynamicStateCreateInfo dynamic{
        .sType = VK_STRUCTURE_TYPE_PIPELINE_DYNAMIC_STATE_CREATE_INFO,
        .dynamicStateCount = 2,
        .pDynamicStates = states};
    const VkPipelineRenderingCreateInfo into{
        .sType = VK_STRUCTURE_TYPE_PIPELINE_RENDERING_CREATE_INFO,
        .colorAttachmentCount = 1,
        .pColorAttachmentFormats = &format,
        .depthAttachmentFormat = depth ? VK_FORMAT_D32_SFLOAT : VK_FORMAT_UNDEFINED};
    const VkGraphicsPipelineCreateInfo asked{.sType =
                                                 VK_STRUCTURE_TYPE_GRAPHICS_PIPELINE_CREATE_INFO,
                                             .pNext = &into,
                                             .stageCount = 2,
                                             .pStages = stages,
                                             .pVertexInputState = &input,
                                             .pInputAssemblyState = &assembly,
                                             .pViewportState = &view,
                                             .pRasterizationState = &raster,
                                             .pMultisampleState = &single,
                                             .pDepthStencilState = &tested,
                                             .pColorBlendState = &blend,
                                             .pDynamicState = &dynamic,
                                             .layout = layout_};
    VkPipeline made;
    check(vkCreateGraphicsPipelines(device, VK_NULL_HANDLE, 1, &asked, nullptr, &made),
          fragment.c_str());
    return made;
  }

  Texture picture_of(const Picture& p, VkFormat format) {
    const VkFilter filter = p.nearest ? VK_FILTER_NEAREST : VK_FILTER_LINEAR;
    return {image_from(format, {p.width, p.height, 1}, p.texels.data(), p.texels.size()).all,
            sampler_of(filter, !p.clamped, !p.clamped)};
  }

  Body body_of(const Mesh& mesh) {
    return {&mesh,
            buffer_of(mesh.vertices.size() * sizeof(Vertex), VK_BUFFER_USAGE_VERTEX_BUFFER_BIT,
                      mesh.vertices.data()),
            buffer_of(mesh.indices.size() * sizeof(std::uint32_t), VK_BUFFER_USAGE_INDEX_BUFFER_BIT,
                      mesh.indices.data()),
            set_of(picture_of(mesh.color, VK_FORMAT_R8G8B8A8_SRGB),
                   picture_of(mesh.roughness, VK_FORMAT_R8G8B8A8_UNORM))};
  }

  // place: left, top, width, height. upwards: clip space's y is up in the picture, as in OpenGL; else down, as textures are stored.
  // over: what the targets hold stays.
  void open_pass(VkImageView color, VkImageView depth, std::array<int, 4> place, bool upwards,
                 bool over = false) {
    wait(buffer_);
    const VkAttachmentLoadOp clears =
        over ? VK_ATTACHMENT_LOAD_OP_LOAD : VK_ATTACHMENT_LOAD_OP_CLEAR;
    const VkRenderingAttachmentInfo into{.sType = VK_STRUCTURE_TYPE_RENDERING_ATTACHMENT_INFO,
                                         .imageView = color,
                                         .imageLayout = VK_IMAGE_LAYOUT_GENERAL,
                                         .loadOp = depth ? clears : VK_ATTACHMENT_LOAD_OP_LOAD,
                                         .storeOp = VK_ATTACHMENT_STORE_OP_STORE};
    const VkRenderingAttachmentInfo tested{.sType = VK_STRUCTURE_TYPE_RENDERING_ATTACHMENT_INFO,
                                           .imageView = depth,
                                           .imageLayout = VK_IMAGE_LAYOUT_GENERAL,
                                           .loadOp = clears,
                                           .storeOp = VK_ATTACHMENT_STORE_OP_STORE,
                                           .clearValue = {.depthStencil = {1.0F, 0}}};
    const VkRect2D area{{place[0], place[1]}, {std::uint32_t(place[2]), std::uint32_t(place[3])}};
    const VkRenderingInfo pass{.sType = VK_STRUCTURE_TYPE_RENDERING_INFO,
                               .renderArea = area,
                               .layerCount = 1,
                               .colorAttachmentCount = 1,
                               .pColorAttachments = &into,
                               .pDepthAttachment = depth ? &tested : nullptr};
    vkCmdBeginRendering(buffer_, &pass);
    const float x = float(place[0]), y = float(place[1]), w = float(place[2]), h = float(place[3]);
    const VkViewport view =
        upwards ? VkViewport{x, y + h, w, -h, 0.0F, 1.0F} : VkViewport{x, y, w, h, 0.0F, 1.0F};
    vkCmdSetViewport(buffer_, 0, 1, &view);
    vkCmdSetScissor(buffer_, 0, 1, &area);
  }

  template <class Block>
  void use(VkPipeline pipeline, VkDescriptorSet set, const Block& block) {
    if (draws_ == most_draws) fail("more meshes than this example has room for");
    const std::uint32_t offset =
        std::uint32_t(aligned(sizeof(FrameBlock)) + aligned(sizeof(DrawBlock)) * draws_++);
    std::memcpy(blocks_.data + offset, &block, sizeof block);
    vkCmdBindPipeline(buffer_, VK_PIPELINE_BIND_POINT_GRAPHICS, pipeline);
    vkCmdBindDescriptorSets(buffer_, VK_PIPELINE_BIND_POINT_GRAPHICS, layout_, 0, 1, &set, 1,
                            &offset);
  }

  void run(VkPipeline pipeline, VkImageView target, std::array<int, 4> place, VkDescriptorSet set,
           const PassBlock& block) {
    open_pass(target, VK_NULL_HANDLE, place, false);
    use(pipeline, set, block);
    vkCmdDraw(buffer_, 3, 1, 0, 0);
    vkCmdEndRendering(buffer_);
  }

  void draw_meshes(VkPipeline pipeline, bool glass) {
    for (const Body& body : bodies_) {
      if (body.mesh->glass != glass) continue;
      use(pipeline, body.set, body.mesh->block);
      const VkDeviceSize from = 0;
      vkCmdBindVertexBuffers(buffer_, 0, 1, &body.vertices.buffer, &from);
      vkCmdBindIndexBuffer(buffer_, body.indices.buffer, 0, VK_INDEX_TYPE_UINT32);
      vkCmdDrawIndexed(buffer_, std::uint32_t(body.mesh->indices.size()), 1, 0, 0, 0);
    }
  }

  // What is not glass, the sky last: only where nothing stands before it.
  void draw_bodies() {
    open_pass(pyramid_.level[0], depth_.level[0], {0, 0, width_, height_}, true);
    draw_meshes(body_, false);
    use(sky_, nothing_, PassBlock{});
    vkCmdDraw(buffer_, 3, 1, 0, 0);
    vkCmdEndRendering(buffer_);
  }

  void copy(const Image& from, const Image& to) {
    const VkImageCopy region{{from.aspect, 0, 0, 1},
                             {},
                             {to.aspect, 0, 0, 1},
                             {},
                             {std::uint32_t(width_), std::uint32_t(height_), 1}};
    vkCmdCopyImage(buffer_, from.image, VK_IMAGE_LAYOUT_GENERAL, to.image, VK_IMAGE_LAYOUT_GENERAL,
                   1, &region);
  }

  // Glass over what was drawn without it.
  void draw_glass() {
    wait(buffer_);
    copy(pyramid_, frame_);
    copy(depth_, frame_depth_);
    open_pass(frame_.level[0], frame_depth_.level[0], {0, 0, width_, height_}, true, true);
    draw_meshes(glass_, true);
    vkCmdEndRendering(buffer_);
  }

  void blur_environment(const Environment& map) {
    const VkFormat half = VK_FORMAT_R16G16B16A16_SFLOAT;
    const VkPipeline sharp = pipeline_of("fullscreen.vert", "environment_sharp.frag", half, false,
                                         false, VK_CULL_MODE_NONE);
    const VkPipeline blur = pipeline_of("fullscreen.vert", "environment_blur.frag", half, false,
                                        false, VK_CULL_MODE_NONE);
    std::vector<std::uint16_t> halves(map.texels.size());
    for (std::size_t i = 0; i < halves.size(); ++i)
      halves[i] = std::uint16_t(glm::packHalf2x16(glm::vec2(map.texels[i], 0.0F)));
    const Texture source{
        image_from(half, {map.width, map.height, 1}, halves.data(), halves.size() * 2).all,
        sampler_of(VK_FILTER_LINEAR, true, false)};
    const VkDescriptorSet first = set_of(source, source), sets[] = {set_of(textures_[EVEN], source),
                                                                    set_of(textures_[ODD], source)};
    draws_ = 0;
    buffer_ = begin();
    for (int k = 0; k < LEVELS; ++k) {
      const Level& one = environment_.level[k];
      run(k == 0 ? sharp : blur, atlas_[k % 2].level[0], {0, one.row, one.size + 2, one.size + 2},
          k == 0 ? first : sets[(k + 1) % 2], environment_.block(k));
    }
    finish(buffer_);
  }

  const Scene& scene_;
  const Levels environment_;
  const int width_, height_, last_;
  std::size_t draws_ = 0;
  VkCommandBuffer buffer_ = VK_NULL_HANDLE;
  VkDescriptorSetLayout set_layout_;
  VkDescriptorPool pool_;
  VkPipelineLayout layout_;
  VkSampler linear_, nearest_;
  VkPipeline sky_, body_, glass_, halve_;
  Buffer blocks_, read_;
  Image pyramid_, depth_, face_depth_, frame_, frame_depth_, atlas_[2];
  std::vector<FaceLayer> faces_;
  Texture textures_[BINDINGS]{};
  VkDescriptorSet nothing_;
  std::vector<VkDescriptorSet> level_sets_;
  std::vector<Body> bodies_;
};

} // namespace

int main(int argc, char** argv) {
  const Asked asked = asked_of(argc, argv);
  open_device();
  const Scene scene = scene_of(asked.scene);
  Renderer renderer(scene, environment_of(asked.environment), asked.width, asked.height,
                    asked.pairs);
  write(averaged_of(renderer, asked), asked, properties.deviceName);
}
