// Device memory: large blocks asked of the driver, handed out in pieces.
#pragma once

#include "gpu/vulkan/api.h"
#include "gpu/vulkan/suballocator.h"

#include <cstddef>
#include <memory>
#include <vector>

namespace gg::gpu::vulkan {

enum class MemoryKind {
  device,   // fastest for the device; the host need not see it
  upload,   // written by the host
  read_back // read by the host
};

struct MemoryBlock;

// A piece of a block. Offsets count from the start of `memory`.
struct Allocation {
  VkDeviceMemory memory = VK_NULL_HANDLE;
  VkDeviceSize offset = 0, bytes = 0;
  std::byte* mapped = nullptr; // where the host sees it; null for MemoryKind::device
  MemoryBlock* block = nullptr;
};

// The type of memory for a kind: the one with the most of what is wanted among those with all that
// is needed. -1 if there is none. Preferred types come first in `properties`, as Vulkan orders
// them.
int memory_type(const VkPhysicalDeviceMemoryProperties& properties, std::uint32_t allowed,
                MemoryKind kind);

class Memory {
public:
  Memory(const DeviceFunctions& functions, VkDevice device,
         const VkPhysicalDeviceMemoryProperties& properties);
  ~Memory(); // everything has been given back or is no longer used
  Memory(const Memory&) = delete;
  Memory& operator=(const Memory&) = delete;

  // `linear` for buffers: they and images are kept in separate blocks, which spares the padding of
  // bufferImageGranularity. VK_ERROR_OUT_OF_DEVICE_MEMORY and the like are returned.
  VkResult take(const VkMemoryRequirements& wanted, MemoryKind kind, bool linear, Allocation& to);
  void give(const Allocation& allocation);

  std::uint64_t block_count() const { return blocks_made_; } // asked of the driver so far

private:
  struct Pool {
    int type = 0;
    MemoryKind kind = MemoryKind::device;
    bool linear = false;
    std::vector<std::unique_ptr<MemoryBlock>> blocks;
    VkDeviceSize bytes = 0;
  };
  Pool& pool(int type, MemoryKind kind, bool linear);
  VkResult add_block(Pool& pool, VkDeviceSize bytes, MemoryBlock*& to);
  void free_block(MemoryBlock& block);

  const DeviceFunctions& vk_;
  VkDevice device_;
  VkPhysicalDeviceMemoryProperties properties_;
  std::vector<std::unique_ptr<Pool>> pools_;
  std::uint64_t blocks_made_ = 0;

  friend struct MemoryBlock;
};

} // namespace gg::gpu::vulkan
