// Turns what a pass records into Vulkan commands, and leaves out those that change nothing.
#pragma once

#include "gpu/checks.h"
#include "gpu/names.h"
#include "gpu/vulkan/descriptors.h"
#include "gpu/vulkan/pipeline.h"
#include "gpu/vulkan/resources.h"

#include <array>
#include <memory>
#include <vector>

namespace gg::gpu::vulkan {

class PassEncoder final : public CheckedEncoder {
public:
  PassEncoder(Context& context, SetCache& sets, const Names& names, const Limits& limits)
      : CheckedEncoder(names), context_(context), vk_(context.vk()), sets_(sets), limits_(limits) {}

  // The barriers of the pass have been issued. Begins drawing into its targets.
  void begin(VkCommandBuffer commands, const Pass& pass);
  void end(); // lets go of everything that was bound

  void use(const PipelineRef& pipeline) override;
  void vertices(int binding, const BufferRef& buffer, std::size_t offset) override;
  void indices(const BufferRef& buffer) override;
  void cull(Cull cull) override;
  void front_is_clockwise(bool clockwise) override;
  void draw(std::uint32_t vertex_count, std::uint32_t instance_count) override;
  void draw_indexed(std::uint32_t index_count, std::uint32_t instance_count,
                    std::uint32_t first_index) override;
  void dispatch(std::uint32_t x, std::uint32_t y, std::uint32_t z) override;

private:
  // What a descriptor holds, and the numbers that tell it from all others.
  struct Descriptor {
    VkDescriptorBufferInfo buffer{};
    VkDescriptorImageInfo image{};
    std::array<std::uint64_t, 3> identity{};
  };

  void begin_drawing();
  void prepare(bool draws); // everything that the next draw or dispatch needs
  void bind_resources();
  bool describe_all(); // true if descriptors (not only offsets) differ from those described last
  Descriptor describe_one(const Slot& slot, const Bound& bound);
  Descriptor describe_buffer(const Slot& slot, const Bound& bound);
  Descriptor describe_texture(const Slot& slot, const Bound& bound);
  Descriptor describe_image(const Slot& slot, const Bound& bound);
  void find_set();
  void check_vertices_are_bound() const;
  GpuPipeline& pipeline() const { return CheckedEncoder::pipeline<GpuPipeline>(); }

  Context& context_;
  const DeviceFunctions& vk_;
  SetCache& sets_;
  const Limits& limits_;

  VkCommandBuffer buffer_ = VK_NULL_HANDLE;

  VkDescriptorSet set_ = VK_NULL_HANDLE;                  // bound now,
  const SetLayout* set_layout_ = nullptr;                 // of this layout,
  std::vector<Descriptor> descriptors_;                   // holding these,
  std::vector<std::uint32_t> offsets_, previous_offsets_; // with these
  SetContents contents_;                                  // kept for their memory
  std::vector<VkWriteDescriptorSet> writes_;

  std::vector<BufferRef> vertices_;
  BufferRef indices_;
};

} // namespace gg::gpu::vulkan
