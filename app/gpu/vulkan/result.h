// What Vulkan's result codes mean to a person.
#pragma once

#include "core/error.h"
#include "gpu/vulkan/api.h"

#include <string>

namespace gg::gpu::vulkan {

// Error(device): what was being done, what went wrong, what to do about it.
Error error_of(VkResult result, const std::string& doing);

// Throws error_of(result) unless the result is VK_SUCCESS. `doing` reads on from "while":
// "creating the texture 'color' (12 MiB)".
inline void check(VkResult result, const char* doing) {
  if (result != VK_SUCCESS) throw error_of(result, doing);
}

// "12.5 MiB"
std::string in_words(std::uint64_t bytes);

} // namespace gg::gpu::vulkan
