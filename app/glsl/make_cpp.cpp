// Build tool: writes the snippets of shaders/ as one C++ text (see cpp_text.h).
//   gg_glsl_make_cpp SHADERS OUT bare|suffixed|wrapped together|alone FILE...
// together: all files, each once, into the including namespace. alone: each file flattened into a
// namespace of its own, which proves that it includes all it needs.
#include "core/error.h"
#include "core/files.h"
#include "glsl/cpp_text.h"
#include "glsl/flatten.h"

#include <algorithm>
#include <cstdio>
#include <sstream>

namespace fs = std::filesystem;

namespace {

std::string undefine_guards(const std::string& text) {
  std::string lines;
  for (const std::string& guard : gg::glsl::include_guards(text))
    lines += "#undef " + guard + "\n";
  return lines;
}

std::string namespace_name(const fs::path& file) {
  std::string name = "alone_" + file.generic_string();
  for (char& c : name)
    if (c == '/' || c == '.' || c == '-') c = '_';
  return name;
}

gg::glsl::Literals literals(const std::string& name) {
  if (name == "bare") return gg::glsl::Literals::bare;
  if (name == "suffixed") return gg::glsl::Literals::suffixed;
  if (name == "wrapped") return gg::glsl::Literals::wrapped;
  throw gg::Error(gg::ExitCode::usage, name, "is no spelling of literals",
                  "Use bare, suffixed or wrapped.");
}

// A comment changes nothing that is compiled, so it is left out: then editing one builds nothing.
std::string without_comments(const std::string& text) {
  std::istringstream in(text);
  std::string lines;
  for (std::string line; std::getline(in, line);) {
    line.erase(std::min(line.find("//"), line.size()));
    line.erase(line.find_last_not_of(' ') + 1);
    if (!line.empty()) lines += line + '\n';
  }
  return lines;
}

std::string generate(const fs::path& root, gg::glsl::Literals spelling, bool alone,
                     const std::vector<fs::path>& files) {
  if (!alone) {
    const std::string text = gg::glsl::flatten(root, files).text;
    return gg::glsl::cpp_text(text, spelling) + undefine_guards(text);
  }
  std::string out;
  for (const fs::path& file : files) {
    const std::string text = gg::glsl::flatten(root, file).text;
    out += "namespace " + namespace_name(file) + " {\n" + gg::glsl::cpp_text(text, spelling) + "}\n"
           + undefine_guards(text);
  }
  return out;
}

} // namespace

int main(int argc, char** argv) try {
  const std::vector<std::string> words(argv + 1, argv + argc);
  if (words.size() < 4) {
    std::fputs("gg_glsl_make_cpp SHADERS OUT bare|suffixed|wrapped together|alone FILE...\n",
               stderr);
    return static_cast<int>(gg::ExitCode::usage);
  }
  const std::vector<fs::path> files(words.begin() + 4, words.end());
  const std::string text =
      without_comments(generate(words[0], literals(words[2]), words[3] == "alone", files));
  // Left as it is, with its time, where it is the same: ninja then builds nothing that includes it.
  if (fs::exists(words[1]) && gg::read_text(words[1]) == text) return 0;
  gg::OutputFile out(words[1]);
  out.write(text);
  out.commit();
  return 0;
} catch (const gg::Error& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return static_cast<int>(error.code());
}
