#include "gpu/vulkan/pipeline_cache.h"

#include "core/cache_directory.h"
#include "core/files.h"
#include "core/sealed.h"

#include <fmt/format.h>

#include <cstring>
#include <string_view>

namespace gg::gpu::vulkan {

namespace {

constexpr std::string_view magic = "ggpipes1";
// More than any driver writes for our few dozen pipelines; keeps a wrong file from filling memory.
constexpr std::size_t largest_file = std::size_t{256} << 20;

} // namespace

std::optional<std::filesystem::path> cache_file(const Abilities& abilities) {
  auto file = cache_directory();
  if (!file) return file;
  std::string driver;
  for (const std::uint8_t byte : abilities.id.driverUUID)
    driver += fmt::format("{:02x}", byte);
  return *file
         / fmt::format("vulkan-{:x}-{:x}-{}.pipelines", abilities.properties.vendorID,
                       abilities.properties.deviceID, driver);
}

bool is_of(const VkPhysicalDeviceProperties& properties, std::span<const std::byte> data) {
  VkPipelineCacheHeaderVersionOne head;
  if (data.size() < sizeof head) return false;
  std::memcpy(&head, data.data(), sizeof head);
  return head.headerSize >= sizeof head && head.headerSize <= data.size()
         && head.headerVersion == VK_PIPELINE_CACHE_HEADER_VERSION_ONE
         && head.vendorID == properties.vendorID && head.deviceID == properties.deviceID
         && std::memcmp(head.pipelineCacheUUID, properties.pipelineCacheUUID, VK_UUID_SIZE) == 0;
}

PipelineCache::PipelineCache(Context& context)
    : context_(context), file_(cache_file(context.adapter().abilities)) {
  std::error_code ignored;
  if (file_ && std::filesystem::is_regular_file(*file_, ignored)) {
    try {
      auto data = unseal(read_file(*file_, largest_file), magic);
      if (data && is_of(context.adapter().abilities.properties, *data)) loaded_ = std::move(*data);
    } catch (const Error&) {
      // Unreadable: as if it were not there.
    }
  }
  const VkPipelineCacheCreateInfo info{.sType = VK_STRUCTURE_TYPE_PIPELINE_CACHE_CREATE_INFO,
                                       .initialDataSize = loaded_.size(),
                                       .pInitialData = loaded_.data()};
  check(context.vk().CreatePipelineCache(context.device(), &info, nullptr, &handle_),
        "creating the pipeline cache");
  context.name(VK_OBJECT_TYPE_PIPELINE_CACHE, handle_, "pipeline cache");
}

PipelineCache::~PipelineCache() {
  try {
    save();
  } catch (const std::exception&) {
    // A full disk or a read-only home: nothing that a picture depends on.
  }
  context_.vk().DestroyPipelineCache(context_.device(), handle_, nullptr);
}

void PipelineCache::save() const {
  if (!file_) return;
  std::size_t bytes = 0;
  const DeviceFunctions& vk = context_.vk();
  check(vk.GetPipelineCacheData(context_.device(), handle_, &bytes, nullptr),
        "measuring the pipeline cache");
  std::vector<std::byte> data(bytes);
  check(vk.GetPipelineCacheData(context_.device(), handle_, &bytes, data.data()),
        "reading the pipeline cache");
  data.resize(bytes);
  if (data == loaded_) return;
  std::filesystem::create_directories(file_->parent_path());
  OutputFile file(*file_);
  file.write(std::span<const std::byte>(seal(data, magic)));
  file.commit();
}

} // namespace gg::gpu::vulkan
