// Descriptor sets: layouts shared between the pipelines that bind the same things, and sets that
// are written again frame after frame instead of being allocated.
#pragma once

#include "gpu/shaders/module.h"
#include "gpu/vulkan/context.h"

#include <map>
#include <memory>
#include <span>
#include <unordered_map>
#include <utility>
#include <vector>

namespace gg::gpu::vulkan {

// Uniform blocks take their offset when they are bound, so that one set serves all objects whose
// blocks lie in one buffer.
VkDescriptorType descriptor_type(shaders::Kind kind);

struct SetLayout {
  VkDescriptorSetLayout set = VK_NULL_HANDLE;
  VkPipelineLayout pipeline = VK_NULL_HANDLE;
  std::vector<VkDescriptorPoolSize> sizes; // of one set; the counts are not 0
};

// Layouts live as long as the device; there are as many as kinds of pipelines.
class SetLayouts {
public:
  explicit SetLayouts(Context& context) : context_(context) {}
  ~SetLayouts();
  SetLayouts(const SetLayouts&) = delete;
  SetLayouts& operator=(const SetLayouts&) = delete;

  const SetLayout& find_or_make(std::span<const shaders::Binding> bindings,
                                VkShaderStageFlags stages);

private:
  using Key = std::pair<VkShaderStageFlags, std::vector<std::pair<unsigned, VkDescriptorType>>>;
  Context& context_;
  std::map<Key, std::unique_ptr<SetLayout>> layouts_;
};

// The sets that one submission uses. restart() makes all of them free again.
class SetArena {
public:
  explicit SetArena(Context& context) : context_(context) {}
  ~SetArena();
  SetArena(const SetArena&) = delete;
  SetArena& operator=(const SetArena&) = delete;

  VkDescriptorSet take(const SetLayout& layout);
  void restart();

private:
  struct Sets {
    std::vector<VkDescriptorSet> sets;
    std::size_t used = 0;
  };
  Context& context_;
  std::vector<VkDescriptorPool> pools_;
  std::unordered_map<const SetLayout*, Sets> sets_;
};

} // namespace gg::gpu::vulkan
