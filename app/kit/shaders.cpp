#include "kit/shaders.h"

#include "core/files.h"
#include "snippet/print.h"

#include <sstream>
#include <string>
#include <vector>

namespace gg::kit {
namespace fs = std::filesystem;
namespace {

constexpr const char* levels = "#define LEVELS 14 // of the environment\n";

std::string first_lines(Target target) {
  const std::string desktop =
      std::string(levels) + R"(#define GG_BLOCK(n) layout(std140, binding = n) uniform
#define GG_SAMPLER(n) layout(binding = n) uniform
#define GG_VARYING(n) layout(location = n)
)";
  switch (target) {
  case Target::opengl:
    return "#version 450 core\n" + desktop + "#define GG_VERTEX gl_VertexID\n";
  case Target::vulkan:
    return "#version 450\n" + desktop + "#define GG_VERTEX gl_VertexIndex\n";
  default: // GLSL ES 3.00 has no bindings, and names what goes from stage to stage
    return "#version 300 es\nprecision highp float;\nprecision highp int;\nprecision highp "
           "sampler3D;\n"
           "precision highp sampler2D;\n"
           + std::string(levels)
           + "#define GG_BLOCK(n) layout(std140) uniform\n#define GG_SAMPLER(n) uniform\n"
             "#define GG_VARYING(n)\n#define GG_VERTEX gl_VertexID\n";
  }
}

std::string expanded(const fs::path& home, const fs::path& file, Target target) {
  std::string out;
  std::istringstream text(read_text(file));
  for (std::string line; std::getline(text, line);) {
    std::istringstream words(line);
    std::string directive;
    words >> directive;
    if (directive == "#snippets") {
      std::vector<std::string> names;
      for (std::string name; words >> name;)
        names.push_back(name);
      const auto language =
          target == Target::webgl2 ? snippet::Target::essl : snippet::Target::glsl;
      out += snippet::print(home / "shaders", names, {language, "gg_", true});
    } else if (directive == "#include") {
      const std::size_t open = line.find('"');
      out += expanded(home, file.parent_path() / line.substr(open + 1, line.rfind('"') - open - 1),
                      target);
    } else {
      out += line + '\n';
    }
  }
  return out;
}

} // namespace

void write_shaders(Target target, const fs::path& home, const fs::path& directory) {
  fs::create_directories(directory / "shaders");
  for (const fs::directory_entry& entry : fs::directory_iterator(home / "assets/kit/shaders")) {
    const fs::path kind = entry.path().extension();
    if (kind != ".vert" && kind != ".frag") continue;
    OutputFile file(directory / "shaders" / entry.path().filename());
    file.write(first_lines(target) + expanded(home, entry.path(), target));
    file.commit();
  }
}

} // namespace gg::kit
