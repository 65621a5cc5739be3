#include "gpu/shader_files.h"

#include "core/files.h"
#include "gpu/shaders/compile.h"
#include "gpu/shaders/module_cache.h"

#include <filesystem>

namespace gg::gpu {

std::vector<std::string> shader_files() {
  namespace fs = std::filesystem;
  std::vector<std::string> files;
  std::error_code none;
  for (const auto& entry : fs::recursive_directory_iterator(home_directory() / "shaders", none))
    for (const char* extension : {".glsl", ".vert", ".frag", ".comp"})
      if (entry.path().extension() == extension) files.push_back(entry.path().string());
  return files;
}

std::string shader_text_hash(const std::string& stage_file) {
  return shaders::text_hash(shaders::stage_path(stage_file));
}

int recompile_changed_shaders(Backend backend) {
  return shaders::recompile_changed(backend);
}

} // namespace gg::gpu
