// How Vulkan's memory is cut up: pieces of blocks, and the choice of a type.
#include "gpu/vulkan/memory.h"
#include "gpu/vulkan/suballocator.h"

#include <gtest/gtest.h>

#include <random>
#include <vector>

namespace gg::gpu::vulkan {
namespace {

struct Piece {
  std::uint64_t offset, bytes;
};

bool overlap(const Piece& a, const Piece& b) {
  return a.offset < b.offset + b.bytes && b.offset < a.offset + a.bytes;
}

TEST(vulkan_suballocator, pieces_are_aligned_and_never_overlap) {
  constexpr std::uint64_t size = 1 << 16;
  Suballocator block(size);
  std::mt19937 random(7);
  std::vector<Piece> taken;
  std::uint64_t held = 0;
  for (int step = 0; step < 4000; ++step) {
    if (!taken.empty() && random() % 5 < 2) {
      const std::size_t i = random() % taken.size();
      block.give(taken[i].offset, taken[i].bytes);
      held -= taken[i].bytes;
      taken[i] = taken.back();
      taken.pop_back();
    } else {
      const std::uint64_t bytes = 1 + random() % 3000, alignment = 1u << (random() % 10);
      const auto offset = block.take(bytes, alignment);
      if (!offset) continue;
      const Piece piece{*offset, bytes};
      ASSERT_EQ(piece.offset % alignment, 0u);
      ASSERT_LE(piece.offset + piece.bytes, size);
      for (const Piece& other : taken)
        ASSERT_FALSE(overlap(piece, other));
      taken.push_back(piece);
      held += bytes;
    }
    ASSERT_EQ(block.free_bytes(), size - held);
  }
  for (const Piece& piece : taken)
    block.give(piece.offset, piece.bytes);
  EXPECT_TRUE(block.empty());
  EXPECT_EQ(block.range_count(), 1u); // all neighbours joined
}

TEST(vulkan_suballocator, padding_before_an_aligned_piece_can_be_taken) {
  Suballocator block(256);
  ASSERT_EQ(block.take(10, 1), 0u);
  ASSERT_EQ(block.take(64, 64), 64u);
  EXPECT_EQ(block.take(54, 1), 10u);
  EXPECT_EQ(block.take(128, 128), 128u);
  EXPECT_EQ(block.free_bytes(), 0u);
  EXPECT_FALSE(block.take(1, 1));
}

TEST(vulkan_suballocator, what_is_too_large_is_refused) {
  Suballocator block(100);
  EXPECT_FALSE(block.take(101, 1));
  ASSERT_EQ(block.take(1, 1), 0u);
  EXPECT_FALSE(block.take(99, 2)); // 98 bytes are left after the alignment
  EXPECT_FALSE(Suballocator(0).take(1, 1));
}

VkPhysicalDeviceMemoryProperties types(std::initializer_list<VkMemoryPropertyFlags> flags) {
  VkPhysicalDeviceMemoryProperties properties{};
  for (const VkMemoryPropertyFlags flag : flags)
    properties.memoryTypes[properties.memoryTypeCount++].propertyFlags = flag;
  return properties;
}

constexpr VkMemoryPropertyFlags local = VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT;
constexpr VkMemoryPropertyFlags host =
    VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT;
constexpr VkMemoryPropertyFlags cached = VK_MEMORY_PROPERTY_HOST_CACHED_BIT;

TEST(vulkan_memory, each_kind_takes_the_type_made_for_it) {
  // As a GPU with its own memory lists them: plain, its own, host's, host's cached, window to its
  // own.
  const auto gpu = types({0, local, host, host | cached, local | host});
  EXPECT_EQ(memory_type(gpu, ~0u, MemoryKind::device), 1);
  EXPECT_EQ(memory_type(gpu, ~0u, MemoryKind::upload), 2);
  EXPECT_EQ(memory_type(gpu, ~0u, MemoryKind::read_back), 3);
  // A software device has one type for everything.
  const auto software = types({local | host | cached});
  for (const MemoryKind kind : {MemoryKind::device, MemoryKind::upload, MemoryKind::read_back})
    EXPECT_EQ(memory_type(software, ~0u, kind), 0);
}

TEST(vulkan_memory, a_type_that_is_not_allowed_is_not_taken) {
  const auto gpu = types({0, local, host, host | cached, local | host});
  EXPECT_EQ(memory_type(gpu, ~(1u << 1), MemoryKind::device), 4);
  EXPECT_EQ(memory_type(gpu, 1u << 4, MemoryKind::upload), 4);
  EXPECT_EQ(memory_type(gpu, 1u << 1, MemoryKind::upload), -1); // the host cannot see it
  EXPECT_EQ(memory_type(gpu, 0, MemoryKind::device), -1);
}

} // namespace
} // namespace gg::gpu::vulkan
