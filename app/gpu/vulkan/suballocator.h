// Where in a block of memory there is room: first fit over the free ranges, neighbours joined when
// given back. Knows nothing of Vulkan.
#pragma once

#include <cstdint>
#include <map>
#include <optional>

namespace gg::gpu::vulkan {

class Suballocator {
public:
  explicit Suballocator(std::uint64_t bytes);

  // The offset of `bytes` > 0 free bytes at a multiple of `alignment` (a power of two), or nothing
  // if no free range is large enough.
  std::optional<std::uint64_t> take(std::uint64_t bytes, std::uint64_t alignment);
  // Gives back what take() returned. Exact: the bytes are those that were asked for.
  void give(std::uint64_t offset, std::uint64_t bytes);

  bool empty() const { return free_bytes_ == bytes_; }
  std::uint64_t bytes() const { return bytes_; }
  std::uint64_t free_bytes() const { return free_bytes_; }
  std::size_t range_count() const { return free_.size(); } // of free ranges: fragmentation

private:
  std::uint64_t bytes_, free_bytes_;
  std::map<std::uint64_t, std::uint64_t> free_; // offset -> bytes; never adjacent, never empty
};

} // namespace gg::gpu::vulkan
