// The pipeline cache on disk: used where it is sound, ignored where it is not.
#include "gpu/fixture.h"
#include "gpu/vulkan/pipeline_cache.h"

#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>

namespace gg::gpu::vulkan {
namespace {
namespace fs = std::filesystem;

std::vector<std::byte> some_bytes(std::size_t count) {
  std::vector<std::byte> bytes(count);
  for (std::size_t i = 0; i < count; ++i)
    bytes[i] = static_cast<std::byte>(i * 37 + 11);
  return bytes;
}

TEST(vulkan_cache, what_is_sealed_comes_back) {
  for (const std::size_t count : {0, 1, 1000})
    EXPECT_EQ(unseal(seal(some_bytes(count))), some_bytes(count));
}

TEST(vulkan_cache, any_damage_is_noticed) {
  const auto sealed = seal(some_bytes(100));
  for (std::size_t i = 0; i < sealed.size(); ++i) {
    auto damaged = sealed;
    damaged[i] ^= std::byte{1};
    EXPECT_FALSE(unseal(damaged)) << "byte " << i;
  }
  for (std::size_t size = 0; size < sealed.size(); ++size)
    EXPECT_FALSE(unseal(std::span(sealed).first(size))) << size << " bytes";
  auto longer = sealed;
  longer.push_back(std::byte{0});
  EXPECT_FALSE(unseal(longer));
}

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

// The cache directory somewhere else, for as long as it lives.
class CacheIn {
public:
  explicit CacheIn(const fs::path& directory) {
    if (const char* before = std::getenv("XDG_CACHE_HOME")) before_ = before;
    ::setenv("XDG_CACHE_HOME", directory.c_str(), 1);
  }
  ~CacheIn() {
    if (before_.empty())
      ::unsetenv("XDG_CACHE_HOME");
    else
      ::setenv("XDG_CACHE_HOME", before_.c_str(), 1);
  }
  CacheIn(const CacheIn&) = delete;
  CacheIn& operator=(const CacheIn&) = delete;

private:
  std::string before_;
};

// Makes a device and a pipeline, and takes them down again.
void use_a_device() {
  const auto device = create_device({.backend = Backend::vulkan, .debug = true});
  device->create(ComputeDesc{"square", stage("square.comp"), {}});
}

fs::path empty_directory(const char* name) {
  const fs::path directory = fs::path(GROUNDGLASS_OUTPUT_DIR) / name;
  fs::remove_all(directory);
  fs::create_directories(directory);
  return directory;
}

TEST(vulkan_cache, is_written_when_the_device_is_closed_and_read_when_it_is_opened) {
  const fs::path directory = empty_directory("vulkan-cache");
  const CacheIn moved(directory);
  use_a_device();
  const fs::path folder = directory / "groundglass";
  ASSERT_TRUE(fs::is_directory(folder));
  const fs::directory_iterator files(folder), none;
  ASSERT_EQ(std::distance(files, none), 1);
  const fs::path file = fs::directory_iterator(folder)->path();
  const auto written = fs::last_write_time(file);
  use_a_device(); // nothing new: nothing to write
  EXPECT_EQ(fs::last_write_time(file), written);
}

TEST(vulkan_cache, a_damaged_file_is_replaced) {
  const fs::path directory = empty_directory("vulkan-cache-damaged");
  const CacheIn moved(directory);
  use_a_device();
  const fs::path file = fs::directory_iterator(directory / "groundglass")->path();
  const auto size = fs::file_size(file);
  std::ofstream(file, std::ios::binary | std::ios::trunc) << "this is no cache";
  use_a_device();
  EXPECT_EQ(fs::file_size(file), size);
}

TEST(vulkan_cache, where_it_cannot_be_written_nothing_happens) {
  const fs::path directory = empty_directory("vulkan-cache-blocked");
  std::ofstream(directory / "groundglass") << "a file where the folder should be";
  const CacheIn moved(directory);
  testing::internal::CaptureStderr();
  use_a_device();
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

} // namespace
} // namespace gg::gpu::vulkan
