#include "glsl/flatten.h"

#include "core/error.h"
#include "glsl/includes.h"

#include <algorithm>
#include <sstream>

namespace gg::glsl {
namespace fs = std::filesystem;
namespace {

class Flattener final : public IncludeWalk {
public:
  explicit Flattener(const fs::path& root) : root_(root) {}

  void take(const fs::path& file) {
    if (!fs::is_regular_file(root_ / file))
      throw Error(ExitCode::input, file.generic_string(), "there is no such snippet",
                  "Paths are relative to shaders/.");
    walk(file);
  }

  Flattened result() && {
    result_.files = files();
    return std::move(result_);
  }

private:
  fs::path path_of(const fs::path& file) override { return root_ / file; }

  fs::path find(const std::string& name, const Place& from) override {
    const std::string where = from.file.generic_string() + ":" + std::to_string(from.line);
    if (name.empty())
      throw Error(ExitCode::input, where, "this #include names no file",
                  "Write #include \"folder/name.glsl\", relative to shaders/.");
    const fs::path file = fs::path(name).lexically_normal();
    if (file.is_absolute() || *file.begin() == "..")
      throw Error(ExitCode::input, where,
                  "includes " + file.generic_string() + ", outside shaders/");
    if (is_open(file))
      throw Error(ExitCode::input, where, "includes " + file.generic_string() + " in a circle");
    if (!fs::is_regular_file(root_ / file))
      throw Error(ExitCode::input, where,
                  "includes " + file.generic_string() + ", which does not exist",
                  "Paths are relative to shaders/.");
    return file;
  }

  void text(std::string_view line, const Place& at) override {
    result_.text.append(line) += '\n';
    result_.lines.push_back({at.file, at.line});
  }

  fs::path root_;
  Flattened result_;
};

} // namespace

Flattened flatten(const fs::path& root, std::span<const fs::path> files) {
  Flattener flattener(root);
  for (const fs::path& file : files)
    flattener.take(file.lexically_normal());
  return std::move(flattener).result();
}

Flattened flatten(const fs::path& root, const fs::path& file) {
  return flatten(root, std::span(&file, 1));
}

std::vector<fs::path> list_snippets(const fs::path& root, const fs::path& folder) {
  std::vector<fs::path> files;
  if (!fs::is_directory(root / folder)) return files;
  for (const auto& entry : fs::recursive_directory_iterator(root / folder))
    if (entry.is_regular_file() && entry.path().extension() == ".glsl")
      files.push_back(entry.path().lexically_relative(root));
  std::ranges::sort(files);
  return files;
}

bool is_fetch(const fs::path& file) {
  return file.stem().string().ends_with("_fetch");
}

std::string essl_precisions() {
  std::string text;
  for (const char* type :
       {"float", "int", "sampler2D", "sampler3D", "samplerCube", "sampler2DArray",
        "sampler2DShadow", "samplerCubeShadow", "sampler2DArrayShadow", "usampler2DArray"})
    text += std::string("precision highp ") + type + ";\n";
  return text;
}

std::string essl_prelude() {
  return "#version 300 es\n" + essl_precisions();
}

std::vector<std::string> include_guards(const std::string& text) {
  std::vector<std::string> guards;
  std::istringstream lines(text);
  std::string asked;
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string directive, name, rest;
    words >> directive >> name >> rest;
    if (directive == "#ifndef") asked = name;
    if (directive == "#define" && name == asked && rest.empty()) guards.push_back(name);
  }
  return guards;
}

} // namespace gg::glsl
