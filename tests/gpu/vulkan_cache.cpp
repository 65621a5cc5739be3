// The pipeline cache on disk: used where it is sound, ignored where it is not.
#include "gpu/fixture.h"
#include "gpu/vulkan/pipeline_cache.h"
#include "support/cache_in.h"

#include <cstring>
#include <filesystem>
#include <fstream>
#include <vector>

namespace gg::gpu::vulkan {
namespace {
namespace fs = std::filesystem;

TEST(vulkan_cache, the_data_of_another_driver_is_not_taken) {
  VkPhysicalDeviceProperties properties{.vendorID = 1, .deviceID = 2};
  properties.pipelineCacheUUID[3] = 4;
  VkPipelineCacheHeaderVersionOne head{.headerSize = sizeof head,
                                       .headerVersion = VK_PIPELINE_CACHE_HEADER_VERSION_ONE,
                                       .vendorID = 1,
                                       .deviceID = 2};
  head.pipelineCacheUUID[3] = 4;
  const auto bytes = [&] { return std::as_bytes(std::span(&head, 1)); };
  EXPECT_TRUE(is_of(properties, bytes()));
  EXPECT_FALSE(is_of(properties, bytes().first(8)));
  head.deviceID = 3;
  EXPECT_FALSE(is_of(properties, bytes()));
  head.deviceID = 2;
  head.pipelineCacheUUID[3] = 5;
  EXPECT_FALSE(is_of(properties, bytes()));
}

// Makes a device and a pipeline, and takes them down again.
void use_a_device() {
  const auto device = create_device({.backend = Backend::vulkan, .debug = true});
  device->create(ComputeDesc{"square", stage("square.comp"), {}});
}

// Beside the folder of shaders.
fs::path only_file(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(folder))
    if (entry.is_regular_file()) files.push_back(entry.path());
  EXPECT_EQ(files.size(), 1u);
  return files.empty() ? fs::path() : files.front();
}

TEST(vulkan_cache, is_written_when_the_device_is_closed_and_read_when_it_is_opened) {
  const fs::path directory = test::empty_directory("vulkan-cache");
  const test::CacheIn moved(directory);
  use_a_device();
  const fs::path folder = directory / "groundglass";
  ASSERT_TRUE(fs::is_directory(folder));
  const fs::path file = only_file(folder);
  const auto written = fs::last_write_time(file);
  use_a_device(); // nothing new: nothing to write
  EXPECT_EQ(fs::last_write_time(file), written);
}

TEST(vulkan_cache, a_damaged_file_is_replaced) {
  const fs::path directory = test::empty_directory("vulkan-cache-damaged");
  const test::CacheIn moved(directory);
  use_a_device();
  const fs::path file = only_file(directory / "groundglass");
  const auto size = fs::file_size(file);
  std::ofstream(file, std::ios::binary | std::ios::trunc) << "this is no cache";
  use_a_device();
  EXPECT_EQ(fs::file_size(file), size);
}

TEST(vulkan_cache, where_it_cannot_be_written_nothing_happens) {
  const fs::path directory = test::empty_directory("vulkan-cache-blocked");
  std::ofstream(directory / "groundglass") << "a file where the folder should be";
  const test::CacheIn moved(directory);
  testing::internal::CaptureStderr();
  use_a_device();
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

} // namespace
} // namespace gg::gpu::vulkan
