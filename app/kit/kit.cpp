#include "kit/kit.h"

#include "core/error.h"
#include "core/files.h"
#include "kit/shaders.h"
#include "kit/tables.h"
#include "snippet/print.h"

#include <array>
#include <utility>

namespace gg::kit {
namespace fs = std::filesystem;
namespace {

constexpr std::array<std::pair<const char*, Target>, 4> targets{{{"three", Target::three},
                                                                 {"webgl2", Target::webgl2},
                                                                 {"opengl", Target::opengl},
                                                                 {"vulkan", Target::vulkan}}};

void copy_file_to(const fs::path& from, const fs::path& to) {
  OutputFile file(to);
  file.write(read_text(from));
  file.commit();
}

// What the kits without three.js share of their instructions.
void write_instructions(const fs::path& home, const fs::path& own, const fs::path& directory) {
  std::string text = read_text(own / "README.md");
  const std::string place = "@PASSES@\n";
  if (const std::size_t at = text.find(place); at != std::string::npos)
    text.replace(at, place.size(), read_text(home / "assets/kit/shaders/PASSES.md"));
  OutputFile file(directory / "README.md");
  file.write(text);
  file.commit();
}

void write_three_shaders(const fs::path& home, const fs::path& directory) {
  const std::string essl = snippet::print(home / "shaders", {"two_pair_refraction"},
                                          {snippet::Target::essl, "gg_", true});
  OutputFile file(directory / "shaders.js");
  file.write("// Made by groundglass kit: two_pair_refraction and what it needs, GLSL ES "
             "3.00.\nexport const refraction = /* glsl */`\n"
             + essl + "`;\n");
  file.commit();
}

} // namespace

std::vector<std::string> target_names() {
  std::vector<std::string> names;
  for (const auto& [name, target] : targets)
    names.emplace_back(name);
  return names;
}

std::optional<Target> target_named(const std::string& name) {
  for (const auto& [known, target] : targets)
    if (name == known) return target;
  return {};
}

void write(Target target, const fs::path& home, const fs::path& directory) {
  std::error_code error;
  fs::create_directories(directory, error);
  if (error)
    throw Error(ExitCode::output, directory.string(), "cannot be made: " + error.message());
  const fs::path own = home / "assets/kit" / targets[static_cast<std::size_t>(target)].first;
  for (const fs::directory_entry& entry : fs::directory_iterator(own))
    if (entry.path().filename() != "README.md")
      copy_file_to(entry.path(), directory / entry.path().filename());
  write_instructions(home, own, directory);
  write_tables(home, directory);
  if (target == Target::opengl || target == Target::vulkan)
    copy_file_to(home / "assets/kit/cpp/scene.h", directory / "scene.h");
  if (target == Target::three) {
    write_three_shaders(home, directory);
    return;
  }
  write_shaders(target, home, directory);
  copy_file_to(home / "assets/scenes/ball-grid.glb", directory / "scene.glb");
  copy_file_to(home / "assets/environments/royal_esplanade_1k.hdr", directory / "environment.hdr");
}

} // namespace gg::kit
