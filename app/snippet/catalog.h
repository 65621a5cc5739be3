// The snippets that can be asked for by name, and what their header blocks say.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace gg::snippet {

// One file of shaders/bsdf, environment, refraction or color. The fields are those of the block of comments that it opens with.
struct Snippet {
  std::filesystem::path file; // relative to shaders/
  std::string name;           // its stem
  std::string summary, frame, alpha, returns, source, limits;
  bool fetches = false; // takes samplers: no C++ and no WGSL
};

std::vector<Snippet> catalog(const std::filesystem::path& shaders); // sorted by file

// By stem ("ggx"), path ("bsdf/ggx" or "bsdf/ggx.glsl") or the name of something that the file declares ("ggxD"). Throws
// Error(usage) with the nearest name if there is none.
const Snippet& find(const std::vector<Snippet>& snippets, const std::filesystem::path& shaders,
                    const std::string& name);

} // namespace gg::snippet
