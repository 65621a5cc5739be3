#include "support/scratch.h"

#include <gtest/gtest.h>

#include <fstream>
#include <set>

namespace gg::test {

std::filesystem::path scratch_directory() {
  const ::testing::TestInfo* const info = ::testing::UnitTest::GetInstance()->current_test_info();
  std::string name = info ? std::string(info->test_suite_name()) + "." + info->name() : "shared";
  for (char& c : name)
    if (c == '/') c = '-'; // parameterised tests
  const std::filesystem::path directory = std::filesystem::path(GROUNDGLASS_OUTPUT_DIR) / name;
  static std::set<std::filesystem::path> used;
  if (used.insert(directory).second) std::filesystem::remove_all(directory);
  std::filesystem::create_directories(directory);
  return directory;
}

std::filesystem::path scratch_file(std::string_view name, std::string_view bytes) {
  const std::filesystem::path path = scratch_directory() / name;
  std::ofstream out(path, std::ios::binary);
  out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  out.close();
  EXPECT_TRUE(out) << path;
  return path;
}

std::filesystem::path scratch_file(std::string_view name, std::span<const std::byte> bytes) {
  return scratch_file(name,
                      std::string_view(reinterpret_cast<const char*>(bytes.data()), bytes.size()));
}

} // namespace gg::test
