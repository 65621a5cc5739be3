// Compiled pipelines kept on disk between runs, so that a driver compiles each only once.
#pragma once

#include "gpu/vulkan/context.h"

#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>
#include <vector>

namespace gg::gpu::vulkan {

// Where the file of a device lies in the cache directory: one file per device and driver. Nothing if there is no such directory.
std::optional<std::filesystem::path> cache_file(const Abilities& abilities);

// True if the data begins with the header that Vulkan prescribes and is of this very driver.
bool is_of(const VkPhysicalDeviceProperties& properties, std::span<const std::byte> data);

class PipelineCache {
public:
  // A file that is missing, damaged or another driver's is ignored: it is written again.
  explicit PipelineCache(Context& context);
  // Saves what was added. Where that is not possible the next run compiles again, nothing more.
  ~PipelineCache();
  PipelineCache(const PipelineCache&) = delete;
  PipelineCache& operator=(const PipelineCache&) = delete;

  VkPipelineCache handle() const { return handle_; }

private:
  void save() const;

  Context& context_;
  std::optional<std::filesystem::path> file_;
  std::vector<std::byte> loaded_;
  VkPipelineCache handle_ = VK_NULL_HANDLE;
};

} // namespace gg::gpu::vulkan
