#include "gpu/vulkan/descriptors.h"

#include <algorithm>

namespace gg::gpu::vulkan {

namespace {

// Sets are allocated this many at a time, from a pool made for just them: nothing is guessed and
// nothing runs out. Large enough that a scene of a thousand draws asks the driver 16 times, once.
constexpr std::uint32_t sets_at_once = 64;

} // namespace

VkDescriptorType descriptor_type(shaders::Kind kind) {
  switch (kind) {
  case shaders::Kind::uniform_block:
    return VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER_DYNAMIC;
  case shaders::Kind::storage_block:
    return VK_DESCRIPTOR_TYPE_STORAGE_BUFFER;
  case shaders::Kind::sampled:
    return VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER;
  case shaders::Kind::image:
    return VK_DESCRIPTOR_TYPE_STORAGE_IMAGE;
  }
  return VK_DESCRIPTOR_TYPE_MAX_ENUM;
}

SetLayouts::~SetLayouts() {
  for (const auto& [key, layout] : layouts_) {
    context_.vk().DestroyPipelineLayout(context_.device(), layout->pipeline, nullptr);
    context_.vk().DestroyDescriptorSetLayout(context_.device(), layout->set, nullptr);
  }
}

const SetLayout& SetLayouts::find_or_make(std::span<const shaders::Binding> bindings,
                                          VkShaderStageFlags stages) {
  Key key{stages, {}};
  for (const auto& binding : bindings)
    key.second.emplace_back(binding.binding, descriptor_type(binding.kind));
  std::sort(key.second.begin(), key.second.end());
  if (const auto found = layouts_.find(key); found != layouts_.end()) return *found->second;

  auto layout = std::make_unique<SetLayout>();
  std::vector<VkDescriptorSetLayoutBinding> entries;
  std::map<VkDescriptorType, std::uint32_t> counts;
  for (const auto& [binding, type] : key.second) {
    entries.push_back(
        {.binding = binding, .descriptorType = type, .descriptorCount = 1, .stageFlags = stages});
    ++counts[type];
  }
  for (const auto& [type, count] : counts)
    layout->sizes.push_back({type, count});

  const DeviceFunctions& vk = context_.vk();
  const VkDescriptorSetLayoutCreateInfo set{
      .sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO,
      .bindingCount = static_cast<std::uint32_t>(entries.size()),
      .pBindings = entries.data()};
  check(vk.CreateDescriptorSetLayout(context_.device(), &set, nullptr, &layout->set),
        "creating the layout of a descriptor set");
  const VkPipelineLayoutCreateInfo pipeline{.sType = VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO,
                                            .setLayoutCount = 1,
                                            .pSetLayouts = &layout->set};
  if (const auto result =
          vk.CreatePipelineLayout(context_.device(), &pipeline, nullptr, &layout->pipeline)) {
    vk.DestroyDescriptorSetLayout(context_.device(), layout->set, nullptr);
    throw error_of(result, "creating the layout of a pipeline");
  }
  context_.counters.created += 2;
  return *layouts_.emplace(std::move(key), std::move(layout)).first->second;
}

SetArena::~SetArena() {
  for (VkDescriptorPool pool : pools_)
    context_.vk().DestroyDescriptorPool(context_.device(), pool, nullptr);
}

VkDescriptorSet SetArena::take(const SetLayout& layout) {
  Sets& sets = sets_[&layout];
  if (sets.used == sets.sets.size()) {
    std::vector<VkDescriptorPoolSize> sizes = layout.sizes;
    for (auto& size : sizes)
      size.descriptorCount *= sets_at_once;
    const VkDescriptorPoolCreateInfo info{.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO,
                                          .maxSets = sets_at_once,
                                          .poolSizeCount = static_cast<std::uint32_t>(sizes.size()),
                                          .pPoolSizes = sizes.data()};
    VkDescriptorPool pool = VK_NULL_HANDLE;
    check(context_.vk().CreateDescriptorPool(context_.device(), &info, nullptr, &pool),
          "creating a pool of descriptors");
    pools_.push_back(pool);
    const std::vector<VkDescriptorSetLayout> layouts(sets_at_once, layout.set);
    const VkDescriptorSetAllocateInfo allocate{.sType =
                                                   VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO,
                                               .descriptorPool = pool,
                                               .descriptorSetCount = sets_at_once,
                                               .pSetLayouts = layouts.data()};
    sets.sets.resize(sets.used + sets_at_once);
    check(context_.vk().AllocateDescriptorSets(context_.device(), &allocate,
                                               sets.sets.data() + sets.used),
          "allocating descriptor sets");
    context_.counters.created += 1 + sets_at_once;
  }
  return sets.sets[sets.used++];
}

void SetArena::restart() {
  for (auto& [layout, sets] : sets_)
    sets.used = 0;
}

} // namespace gg::gpu::vulkan
