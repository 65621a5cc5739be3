// The snippets under test: whatever lies in these folders, so that a new file is covered from its
// first day.
#pragma once

#include "glsl/flatten.h"

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

namespace gg::snippet_test {

inline std::filesystem::path shaders() {
  return std::filesystem::path(GROUNDGLASS_SOURCE_DIR) / "shaders";
}

inline std::vector<std::filesystem::path> snippets() {
  std::vector<std::filesystem::path> all;
  for (const char* folder : {"bsdf", "color", "environment", "refraction"}) {
    const auto files = glsl::list_snippets(shaders(), folder);
    all.insert(all.end(), files.begin(), files.end());
  }
  return all;
}

// bsdf/ggx.glsl -> bsdf_ggx, for the name of a test.
inline std::string test_name(const std::filesystem::path& file) {
  std::string name = (file.parent_path() / file.stem()).generic_string();
  std::ranges::replace_if(
      name, [](char c) { return !std::isalnum(static_cast<unsigned char>(c)); }, '_');
  return name;
}

} // namespace gg::snippet_test
