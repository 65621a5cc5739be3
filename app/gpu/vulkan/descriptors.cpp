#include "gpu/vulkan/descriptors.h"

#include <algorithm>

namespace gg::gpu::vulkan {

namespace {

// Sets are allocated this many at a time, from a pool made for just them: nothing is guessed and
// nothing runs out. Large enough that a scene of a thousand draws asks the driver 16 times, once.
constexpr std::uint32_t sets_at_once = 64;
// A set that no submission has used for so long holds what is gone, or can well be written again.
constexpr std::uint64_t forgotten_after = 64;

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
  std::string label;
  for (const auto& binding : bindings) {
    label += (label.empty() ? "" : ", ") + binding.name;
    key.second.emplace_back(binding.binding, descriptor_type(binding.kind));
  }
  std::sort(key.second.begin(), key.second.end());
  if (const auto found = layouts_.find(key); found != layouts_.end()) return *found->second;

  auto layout = std::make_unique<SetLayout>();
  layout->label = label.empty() ? "nothing" : std::move(label);
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
  context_.name(VK_OBJECT_TYPE_DESCRIPTOR_SET_LAYOUT, layout->set, layout->label);
  context_.name(VK_OBJECT_TYPE_PIPELINE_LAYOUT, layout->pipeline, layout->label);
  context_.counters.created += 2;
  return *layouts_.emplace(std::move(key), std::move(layout)).first->second;
}

std::size_t SetCache::Hash::operator()(const SetContents& contents) const {
  std::uint64_t hash = 0xcbf29ce484222325ull; // FNV-1a, by words
  for (const std::uint64_t word : contents)
    hash = (hash ^ word) * 0x100000001b3ull;
  return static_cast<std::size_t>(hash ^ (hash >> 32));
}

SetCache::~SetCache() {
  for (VkDescriptorPool pool : pools_)
    context_.vk().DestroyDescriptorPool(context_.device(), pool, nullptr);
}

SetCache::Found SetCache::find(const SetLayout& layout, const SetContents& contents) {
  Sets& sets = sets_[&layout];
  const std::uint64_t now = context_.submitted + 1;
  if (const auto known = sets.by_contents.find(contents); known != sets.by_contents.end()) {
    known->second->last_use = now;
    sets.by_use.splice(sets.by_use.begin(), sets.by_use, known->second);
    return {known->second->set, true};
  }

  Entry entry{contents, VK_NULL_HANDLE, now};
  if (!sets.by_use.empty()) {
    const Entry& oldest = sets.by_use.back();
    if (oldest.last_use + forgotten_after < now && oldest.last_use <= context_.completed()) {
      entry.set = oldest.set;
      sets.by_contents.erase(oldest.contents);
      sets.by_use.pop_back();
    }
  }
  if (!entry.set) entry.set = take_blank(layout, sets);
  sets.by_use.push_front(std::move(entry));
  sets.by_contents.emplace(contents, sets.by_use.begin());
  return {sets.by_use.front().set, false};
}

VkDescriptorSet SetCache::take_blank(const SetLayout& layout, Sets& sets) {
  if (sets.blank.empty()) {
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
    context_.name(VK_OBJECT_TYPE_DESCRIPTOR_POOL, pool, layout.label);
    const std::vector<VkDescriptorSetLayout> layouts(sets_at_once, layout.set);
    const VkDescriptorSetAllocateInfo allocate{.sType =
                                                   VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO,
                                               .descriptorPool = pool,
                                               .descriptorSetCount = sets_at_once,
                                               .pSetLayouts = layouts.data()};
    std::vector<VkDescriptorSet> made(sets_at_once);
    check(context_.vk().AllocateDescriptorSets(context_.device(), &allocate, made.data()),
          "allocating descriptor sets");
    // The sets themselves go unnamed: Mesa 22 loses the names of sets that end with their pool.
    sets.blank = std::move(made);
    ++context_.counters.created;
  }
  const VkDescriptorSet set = sets.blank.back();
  sets.blank.pop_back();
  ++context_.counters.created;
  return set;
}

} // namespace gg::gpu::vulkan
