#include "glsl/flatten.h"

#include "core/error.h"
#include "core/files.h"

#include <algorithm>
#include <sstream>

namespace gg::glsl {
namespace fs = std::filesystem;
namespace {

std::string place(const fs::path& file, int line) {
  return file.generic_string() + ":" + std::to_string(line);
}

// The file that an #include line asks for, relative to the root; empty if the line is something
// else.
fs::path included(const std::string& line, const std::string& where) {
  const std::size_t hash = line.find_first_not_of(" \t");
  if (hash == std::string::npos || line[hash] != '#') return {};
  const std::size_t word = line.find_first_not_of(" \t", hash + 1);
  if (word == std::string::npos || line.compare(word, 7, "include") != 0) return {};
  const std::size_t open = line.find('"', word);
  const std::size_t close = open == std::string::npos ? open : line.find('"', open + 1);
  if (close == std::string::npos || close == open + 1)
    throw Error(ExitCode::input, where, "this #include names no file",
                "Write #include \"folder/name.glsl\", relative to shaders/.");
  const fs::path file = fs::path(line.substr(open + 1, close - open - 1)).lexically_normal();
  if (file.is_absolute() || *file.begin() == "..")
    throw Error(ExitCode::input, where, "includes " + file.generic_string() + ", outside shaders/");
  return file;
}

class Flattener {
public:
  explicit Flattener(const fs::path& root) : root_(root) {}

  void take(const fs::path& file, const std::string& where) {
    if (std::ranges::find(open_, file) != open_.end())
      throw Error(ExitCode::input, where, "includes " + file.generic_string() + " in a circle");
    if (std::ranges::find(result_.files, file) != result_.files.end()) return;
    if (!fs::is_regular_file(root_ / file))
      throw Error(ExitCode::input, where.empty() ? file.generic_string() : where,
                  where.empty() ? "there is no such snippet"
                                : "includes " + file.generic_string() + ", which does not exist",
                  "Paths are relative to shaders/.");
    result_.files.push_back(file);
    open_.push_back(file);
    std::istringstream text(read_text(root_ / file));
    int number = 0;
    for (std::string line; std::getline(text, line);) {
      if (!line.empty() && line.back() == '\r') line.pop_back();
      const std::string here = place(file, ++number);
      const fs::path wanted = included(line, here);
      if (!wanted.empty()) {
        take(wanted, here);
        continue;
      }
      result_.text += line + '\n';
      result_.lines.push_back({file, number});
    }
    open_.pop_back();
  }

  Flattened result() && { return std::move(result_); }

private:
  fs::path root_;
  Flattened result_;
  std::vector<fs::path> open_; // the chain of includes that leads to the current file
};

} // namespace

Flattened flatten(const fs::path& root, std::span<const fs::path> files) {
  Flattener flattener(root);
  for (const fs::path& file : files)
    flattener.take(file.lexically_normal(), {});
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
