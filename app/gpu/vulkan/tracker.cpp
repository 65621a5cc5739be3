#include "gpu/vulkan/tracker.h"

namespace gg::gpu::vulkan {

namespace {

template <typename Flags>
bool contains(Flags set, Flags part) {
  return (set & part) == part;
}

} // namespace

std::optional<Barrier> advance(State& state, const Access& access) {
  const bool moves = access.layout != state.layout;

  if (!access.writes && !moves) { // read after write, or after a read that already waited for it
    const bool visible = state.write_stages == 0
                         || (contains(state.visible_stages, access.stages)
                             && contains(state.visible_access, access.access));
    state.read_stages |= access.stages;
    if (visible) return std::nullopt;
    state.visible_stages |= access.stages;
    state.visible_access |= access.access;
    return Barrier{state.write_stages, state.write_access, access.stages,
                   access.access,      state.layout,       state.layout};
  }

  // A write and a change of layout wait for everything before. Reads have nothing to make
  // available: they are waited for, and only the write's access is named.
  const Barrier barrier{state.write_stages | state.read_stages,
                        state.write_access,
                        access.stages,
                        access.access,
                        access.overwrites ? VK_IMAGE_LAYOUT_UNDEFINED : state.layout,
                        access.layout};
  const bool needed = moves || barrier.source_stages != 0;
  // A change of layout happens before the stages that waited for it and can be waited for through
  // them only.
  state = {.layout = access.layout,
           .write_stages = access.stages,
           .write_access = access.writes ? access.access : VkAccessFlags2{0},
           .visible_stages = access.writes ? VkPipelineStageFlags2{0} : access.stages,
           .visible_access = access.writes ? VkAccessFlags2{0} : access.access,
           .read_stages = access.writes ? VkPipelineStageFlags2{0} : access.stages};
  return needed ? std::optional(barrier) : std::nullopt;
}

} // namespace gg::gpu::vulkan
