// Where a test may write.
#pragma once

#include <filesystem>
#include <span>
#include <string_view>

namespace gg::test {

// A directory of the running test's own, under the build's test-output: empty at its first use in
// the process, and left there afterwards to look at.
std::filesystem::path scratch_directory();

// A file in it with these bytes.
std::filesystem::path scratch_file(std::string_view name, std::string_view bytes);
std::filesystem::path scratch_file(std::string_view name, std::span<const std::byte> bytes);

} // namespace gg::test
