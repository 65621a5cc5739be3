// Descriptor sets: layouts shared between the pipelines that bind the same things, and sets that
// are kept for what they hold.
#pragma once

#include "gpu/shaders/module.h"
#include "gpu/vulkan/context.h"

#include <list>
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
  std::string label;                       // the names bound by the pipeline that it was made for
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

// What a descriptor set holds, as numbers that are never used for anything else again.
using SetContents = std::vector<std::uint64_t>;

// Sets by what they hold: written once, found again frame after frame. Those of objects that are
// gone are written again for others.
class SetCache {
public:
  explicit SetCache(Context& context) : context_(context) {}
  ~SetCache();
  SetCache(const SetCache&) = delete;
  SetCache& operator=(const SetCache&) = delete;

  struct Found {
    VkDescriptorSet set = VK_NULL_HANDLE;
    bool holds_it = false; // else it is the caller's to write, now
  };
  // For use in the submission that is being recorded.
  Found find(const SetLayout& layout, const SetContents& contents);

private:
  struct Entry {
    SetContents contents;
    VkDescriptorSet set = VK_NULL_HANDLE;
    std::uint64_t last_use = 0; // the submission's value on the timeline
  };
  struct Hash {
    std::size_t operator()(const SetContents& contents) const;
  };
  struct Sets {
    std::list<Entry> by_use; // the latest first
    std::unordered_map<SetContents, std::list<Entry>::iterator, Hash> by_contents;
    std::vector<VkDescriptorSet> blank;
  };
  VkDescriptorSet take_blank(const SetLayout& layout, Sets& sets);

  Context& context_;
  std::vector<VkDescriptorPool> pools_;
  std::unordered_map<const SetLayout*, Sets> sets_;
};

} // namespace gg::gpu::vulkan
