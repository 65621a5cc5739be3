// Finds the files that stages include. Implementation of compile.cpp.
#pragma once

#include <glslang/Public/ShaderLang.h>

#include <deque>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>

namespace gg::gpu::shaders {

// "stages/opaque.vert" for a file in shaders/, the path itself for any other.
std::string display_name(const std::filesystem::path& file);

// The file that `header` names: in shaders/, else beside `from`; nothing if neither is there.
std::optional<std::filesystem::path> find_include(const std::string& header,
                                                  const std::filesystem::path& from);

// Looks in shaders/, then beside the including file. A file is handed out once per compilation, so
// that snippets need no guards and may include each other freely.
class Includes final : public glslang::TShader::Includer {
public:
  // `root` is the stage's own file and `name` the name that the compiler was given for it.
  Includes(const std::string& name, const std::filesystem::path& root);

  IncludeResult* includeLocal(const char* header, const char* includer, std::size_t depth) override;
  IncludeResult* includeSystem(const char* header, const char* includer,
                               std::size_t depth) override;
  void releaseInclude(IncludeResult*) override {} // all live as long as this does

private:
  struct File {
    std::string text;
    IncludeResult result;
    File(const std::string& name, std::string contents)
        : text(std::move(contents)), result(name, text.data(), text.size(), nullptr) {}
  };
  std::map<std::string, std::filesystem::path> paths_; // by display name
  std::set<std::filesystem::path> seen_;
  std::deque<File> files_; // results point into their texts: a deque never moves them
};

} // namespace gg::gpu::shaders
