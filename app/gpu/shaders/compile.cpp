#include "gpu/shaders/compile.h"

#include "core/error.h"
#include "core/files.h"
#include "gpu/shaders/includes.h"
#include "gpu/shaders/module_cache.h"

#include <glslang/Public/ResourceLimits.h>
#include <glslang/Public/ShaderLang.h>
#include <glslang/SPIRV/GlslangToSpv.h>

#include <filesystem>
#include <future>
#include <map>
#include <mutex>
#include <sstream>

namespace gg::gpu::shaders {
namespace fs = std::filesystem;
namespace {

// Stages are written in Vulkan's dialect. OpenGL calls the indices Id and counts from 0, Vulkan
// counts from the draw's first vertex or instance, which is always 0 here. The second extension is
// there for one thing: with it the compiler lets a name that begins with gl_ be defined.
constexpr const char* opengl_prelude = "#extension GL_GOOGLE_include_directive : require\n"
                                       "#extension GL_EXT_spirv_intrinsics : require\n"
                                       "#define gl_VertexIndex gl_VertexID\n"
                                       "#define gl_InstanceIndex gl_InstanceID\n";
constexpr const char* vulkan_prelude = "#extension GL_GOOGLE_include_directive : require\n";

constexpr int glsl_version = 450;

// The compiler's tables, built at first use and taken down at exit.
struct Compiler {
  Compiler() { glslang::InitializeProcess(); }
  ~Compiler() { glslang::FinalizeProcess(); }
};

const Compiler& compiler() {
  static const Compiler only;
  return only;
}

EShLanguage language(Stage stage) {
  switch (stage) {
  case Stage::vertex:
    return EShLangVertex;
  case Stage::fragment:
    return EShLangFragment;
  case Stage::compute:
    return EShLangCompute;
  }
  return EShLangCount;
}

// Whether this is the "stages/x.frag:7" that the compiler puts before a message.
bool is_place(std::string_view text) {
  const std::size_t colon = text.rfind(':');
  return colon != std::string_view::npos && colon + 1 < text.size()
         && text.find_first_not_of("0123456789", colon + 1) == std::string_view::npos;
}

// The compiler says "ERROR: stages/x.frag:7: 'y' : undeclared identifier", then a count. Splits
// that into the first place and the list without the prefixes.
[[noreturn]] void fail(const std::string& name, const std::string& log) {
  constexpr std::string_view prefix = "ERROR: ";
  std::istringstream lines(log);
  std::string line, place = name, text;
  while (std::getline(lines, line)) {
    if (line.empty() || line.find("compilation errors.") != std::string::npos) continue;
    if (line.starts_with(prefix)) line.erase(0, prefix.size());
    const std::size_t message = line.find(": ");
    if (text.empty() && is_place(line.substr(0, message))) {
      place = line.substr(0, message);
      line.erase(0, message + 2);
    }
    text += (text.empty() ? "" : "\n  ") + line;
  }
  throw Error(ExitCode::internal, place, text);
}

Module build(const std::string& name, const fs::path& file, Stage stage, const std::string& text,
             Backend backend) {
  compiler();
  const bool vulkan = backend == Backend::vulkan;
  const auto client = vulkan ? glslang::EShClientVulkan : glslang::EShClientOpenGL;

  glslang::TShader shader(language(stage));
  const char* string = text.data();
  const int length = static_cast<int>(text.size());
  const char* shown = name.c_str();
  shader.setStringsWithLengthsAndNames(&string, &length, &shown, 1);
  shader.setPreamble(vulkan ? vulkan_prelude : opengl_prelude);
  shader.setEnvInput(glslang::EShSourceGlsl, language(stage), client, vulkan ? 100 : glsl_version);
  shader.setEnvClient(client, vulkan ? glslang::EShTargetVulkan_1_1 : glslang::EShTargetOpenGL_450);
  shader.setEnvTarget(glslang::EShTargetSpv,
                      vulkan ? glslang::EShTargetSpv_1_3 : glslang::EShTargetSpv_1_0);
  const auto rules =
      static_cast<EShMessages>(EShMsgSpvRules | (vulkan ? EShMsgVulkanRules : EShMsgDefault));

  Includes includes(name, file);
  if (!shader.parse(GetDefaultResources(), glsl_version, false, rules, includes))
    fail(name, shader.getInfoLog());
  glslang::TProgram program;
  program.addShader(&shader);
  if (!program.link(rules)) fail(name, program.getInfoLog());

  Module module{name, stage, {}};
  glslang::SpvOptions options;
  options.disableOptimizer = true; // specialize() is where code is removed
  glslang::GlslangToSpv(*program.getIntermediate(language(stage)), module.words, &options);
  return module;
}

using ModuleRef = std::shared_ptr<const Module>;

// What has been compiled or is being compiled.
struct Modules {
  using Key = std::pair<fs::path, Backend>;
  std::mutex mutex;
  std::map<Key, std::shared_future<ModuleRef>> known;

  // Statics that threads use must outlive this one: at exit its futures wait for them.
  Modules() {
    compiler();
    home_directory();
  }

  // Deferred: compiled on the first thread that asks.
  std::shared_future<ModuleRef> start(std::string_view stage_file, Backend backend) {
    Key key{stage_path(stage_file), backend};
    const std::lock_guard lock(mutex);
    std::shared_future<ModuleRef>& module = known[key];
    if (!module.valid())
      module = std::async(std::launch::deferred, [key] {
        const fs::path& file = key.first;
        return std::make_shared<const Module>(
            build(display_name(file), file, stage_of(file), read_text(file), key.second));
      });
    return module;
  }

  void replace(const std::map<fs::path, ModuleRef>& fresh, Backend backend) {
    const std::lock_guard lock(mutex);
    for (const auto& [file, module] : fresh) {
      std::promise<ModuleRef> made;
      made.set_value(module);
      known[{file, backend}] = made.get_future();
    }
    // What is compiled for another API is of the text before.
    std::erase_if(known, [&](const auto& one) {
      return one.first.second != backend && fresh.contains(one.first.first);
    });
  }
};

Modules& modules() {
  static Modules all;
  return all;
}

} // namespace

Stage stage_of(const fs::path& file) {
  const std::string extension = file.extension().string();
  if (extension == ".vert") return Stage::vertex;
  if (extension == ".frag") return Stage::fragment;
  if (extension == ".comp") return Stage::compute;
  throw Error(ExitCode::internal, file,
              "is not a stage: its name ends in none of .vert .frag .comp");
}

int recompile_changed(Backend backend) {
  std::map<fs::path, ModuleRef> fresh;
  std::map<fs::path, std::string> hashes;
  for (const fs::directory_entry& entry : fs::directory_iterator(stage_path(""))) {
    const fs::path& file = entry.path();
    const std::string extension = file.extension().string();
    if (extension != ".vert" && extension != ".frag" && extension != ".comp") continue;
    const std::string known = text_hash(file), now = text_hash_on_disk(file);
    if (now == known) continue;
    hashes[file] = now;
    fresh[file] = std::make_shared<const Module>(
        build(display_name(file), file, stage_of(file), read_text(file), backend));
  }
  modules().replace(fresh, backend);
  remember_text_hashes(hashes);
  return static_cast<int>(fresh.size());
}

void keep_modules() {
  modules();
}

fs::path stage_path(std::string_view stage_file) {
  return home_directory() / "shaders" / "stages" / stage_file;
}

std::shared_ptr<const Module> compile(std::string_view stage_file, Backend backend) {
  return modules().start(stage_file, backend).get();
}

Module compile_text(const std::string& name, Stage stage, const std::string& text,
                    Backend backend) {
  return build(name, home_directory() / "shaders" / name, stage, text, backend);
}

} // namespace gg::gpu::shaders
