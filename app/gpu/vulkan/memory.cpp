#include "gpu/vulkan/memory.h"

#include <algorithm>
#include <array>
#include <bit>

namespace gg::gpu::vulkan {

namespace {

// Blocks of a pool grow with it, so that a small scene takes little and a large one asks rarely:
// drivers promise only 4096 allocations (maxMemoryAllocationCount).
constexpr VkDeviceSize smallest_block = VkDeviceSize{4} << 20;
constexpr VkDeviceSize largest_block = VkDeviceSize{128} << 20;

} // namespace

struct MemoryBlock {
  MemoryBlock(VkDeviceSize bytes) : ranges(bytes) {}
  VkDeviceMemory memory = VK_NULL_HANDLE;
  std::byte* mapped = nullptr;
  Suballocator ranges;
  Memory::Pool* pool = nullptr;
};

int memory_type(const VkPhysicalDeviceMemoryProperties& properties, std::uint32_t allowed,
                MemoryKind kind) {
  constexpr VkMemoryPropertyFlags host =
      VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT;
  const VkMemoryPropertyFlags needed = kind == MemoryKind::device ? 0 : host;
  VkMemoryPropertyFlags wanted = VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT, unwanted = 0;
  if (kind == MemoryKind::upload) wanted = 0, unwanted = VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT;
  if (kind == MemoryKind::read_back)
    wanted = VK_MEMORY_PROPERTY_HOST_CACHED_BIT, unwanted = VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT;

  int best = -1, best_score = 0;
  for (int i = 0; i < static_cast<int>(properties.memoryTypeCount); ++i) {
    const VkMemoryPropertyFlags has = properties.memoryTypes[i].propertyFlags;
    if (!(allowed & (1u << i)) || (has & needed) != needed) continue;
    const int score = 2 * std::popcount(has & wanted) - std::popcount(has & unwanted);
    if (best < 0 || score > best_score) best = i, best_score = score;
  }
  return best;
}

Memory::Memory(const DeviceFunctions& functions, VkDevice device,
               const VkPhysicalDeviceMemoryProperties& properties)
    : vk_(functions), device_(device), properties_(properties) {}

Memory::~Memory() {
  for (const auto& pool : pools_)
    for (const auto& block : pool->blocks)
      vk_.FreeMemory(device_, block->memory, nullptr);
}

Memory::Pool& Memory::pool(int type, MemoryKind kind, bool linear) {
  for (const auto& pool : pools_)
    if (pool->type == type && pool->kind == kind && pool->linear == linear) return *pool;
  pools_.push_back(std::make_unique<Pool>(Pool{.type = type, .kind = kind, .linear = linear}));
  return *pools_.back();
}

VkResult Memory::add_block(Pool& pool, VkDeviceSize bytes, MemoryBlock*& to) {
  auto block = std::make_unique<MemoryBlock>(bytes);
  block->pool = &pool;
  const VkMemoryAllocateInfo info{.sType = VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO,
                                  .allocationSize = bytes,
                                  .memoryTypeIndex = static_cast<std::uint32_t>(pool.type)};
  VkResult result = vk_.AllocateMemory(device_, &info, nullptr, &block->memory);
  if (result != VK_SUCCESS) return result;
  if (pool.kind != MemoryKind::device) {
    void* mapped = nullptr;
    result = vk_.MapMemory(device_, block->memory, 0, VK_WHOLE_SIZE, 0, &mapped);
    if (result != VK_SUCCESS) {
      vk_.FreeMemory(device_, block->memory, nullptr);
      return result;
    }
    block->mapped = static_cast<std::byte*>(mapped);
  }
  ++blocks_made_;
  pool.bytes += bytes;
  to = block.get();
  pool.blocks.push_back(std::move(block));
  return VK_SUCCESS;
}

void Memory::free_block(MemoryBlock& block) {
  Pool& pool = *block.pool;
  pool.bytes -= block.ranges.bytes();
  vk_.FreeMemory(device_, block.memory, nullptr);
  std::erase_if(pool.blocks, [&](const auto& other) { return other.get() == &block; });
}

VkResult Memory::take(const VkMemoryRequirements& wanted, MemoryKind kind, bool linear,
                      Allocation& to) {
  const int type = memory_type(properties_, wanted.memoryTypeBits, kind);
  if (type < 0) return VK_ERROR_OUT_OF_DEVICE_MEMORY;
  Pool& from = pool(type, kind, linear);

  const auto place = [&](MemoryBlock& block) {
    const auto offset = block.ranges.take(wanted.size, wanted.alignment);
    if (offset)
      to = {block.memory, *offset, wanted.size, block.mapped ? block.mapped + *offset : nullptr,
            &block};
    return offset.has_value();
  };
  for (const auto& block : from.blocks)
    if (place(*block)) return VK_SUCCESS;

  // A block as large as all so far; what would fill more than half of one gets a block of its own;
  // and where the driver has no room for a block it may have room for exactly what is asked.
  const VkDeviceSize usual = std::clamp(from.bytes, smallest_block, largest_block);
  std::array<VkDeviceSize, 2> sizes{wanted.size, wanted.size};
  if (wanted.size <= usual / 2) sizes[0] = usual;
  VkResult result = VK_ERROR_OUT_OF_DEVICE_MEMORY;
  for (const VkDeviceSize size : sizes) {
    MemoryBlock* block = nullptr;
    result = add_block(from, size, block);
    if (result != VK_SUCCESS) continue;
    place(*block);
    return VK_SUCCESS;
  }
  return result;
}

void Memory::give(const Allocation& allocation) {
  if (!allocation.block) return;
  MemoryBlock& block = *allocation.block;
  block.ranges.give(allocation.offset, allocation.bytes);
  if (!block.ranges.empty()) return;
  // One empty block per pool is kept, so that what comes and goes costs no call to the driver.
  const auto& blocks = block.pool->blocks;
  const auto empty = std::count_if(blocks.begin(), blocks.end(),
                                   [](const auto& other) { return other->ranges.empty(); });
  if (empty > 1 || block.ranges.bytes() > largest_block) free_block(block);
}

} // namespace gg::gpu::vulkan
