#include "gpu/vulkan/suballocator.h"

#include <iterator>

namespace gg::gpu::vulkan {

Suballocator::Suballocator(std::uint64_t bytes) : bytes_(bytes), free_bytes_(bytes) {
  if (bytes > 0) free_.emplace(0, bytes);
}

std::optional<std::uint64_t> Suballocator::take(std::uint64_t bytes, std::uint64_t alignment) {
  for (auto range = free_.begin(); range != free_.end(); ++range) {
    const auto [begin, size] = *range;
    const std::uint64_t at = (begin + alignment - 1) & ~(alignment - 1);
    const std::uint64_t padding = at - begin;
    if (padding > size || size - padding < bytes) continue;

    // What lies before and after stays free; the padding is not part of the allocation, so that it
    // can be given to a smaller one.
    const std::uint64_t rest = size - padding - bytes;
    if (padding > 0)
      range->second = padding;
    else
      free_.erase(range);
    if (rest > 0) free_.emplace(at + bytes, rest);
    free_bytes_ -= bytes;
    return at;
  }
  return std::nullopt;
}

void Suballocator::give(std::uint64_t offset, std::uint64_t bytes) {
  auto range = free_.emplace(offset, bytes).first;
  free_bytes_ += bytes;
  const auto after = std::next(range);
  if (after != free_.end() && range->first + range->second == after->first) {
    range->second += after->second;
    free_.erase(after);
  }
  if (range != free_.begin()) {
    const auto before = std::prev(range);
    if (before->first + before->second == range->first) {
      before->second += range->second;
      free_.erase(range);
    }
  }
}

} // namespace gg::gpu::vulkan
