// From the GLSL text of a stage to SPIR-V, and on to the modules of a pipeline.
#pragma once

#include "gpu/device.h"
#include "gpu/shaders/module.h"

#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>

namespace gg::gpu::shaders {

// Compiles a stage for one API. `stage_file` is relative to shaders/stages (an absolute path is
// taken as it is); its extension (.vert, .frag, .comp) says which stage it is. `#include "x"` is
// looked up in shaders/, then beside the file that includes it, and each file is included at most
// once. Compiled modules, and failures, are remembered for the life of the process. Safe to call
// from several threads.
//
// The text is in Vulkan's dialect (gl_VertexIndex, gl_InstanceIndex: both count from 0, no draw
// starts elsewhere); for OpenGL a prelude renames. gl_FragCoord counts rows from row 0 of the
// target in both.
//
// Throws Error(internal) with the compiler's log, naming file and line; Error(input) if the file
// cannot be read.
std::shared_ptr<const Module> compile(std::string_view stage_file, Backend backend);

// Compiles every stage again whose text on disk, with what it includes, is no longer what was compiled; pipelines that are linked
// from then on are of the new text. Throws as compile() of the first that fails: all stages are as before then. Returns how many
// were compiled; the first call compares with the text that it finds. Safe on any thread.
int recompile_changed(Backend backend);

// Builds what compile() keeps for the life of the process: a static whose threads compile is made after it, and so ends before it.
void keep_modules();

// The file of a stage, and which stage its extension says it is: Error(internal) if none.
std::filesystem::path stage_path(std::string_view stage_file);
Stage stage_of(const std::filesystem::path& file);

// The same from text in memory, not remembered; `name` stands for the file in messages and is
// where relative includes are looked up.
Module compile_text(const std::string& name, Stage stage, const std::string& text, Backend backend);

// The module with its specialization constants fixed at the values given (else at their defaults)
// and everything that cannot be reached any more removed: a texture that only a disabled feature
// reads is no longer declared. Ids that the module does not have are ignored.
Module specialize(const Module& module, std::span<const Constant> constants, Backend backend);

// The stages of one pipeline, specialised, and the union of what they bind.
struct Program {
  std::vector<Module> modules;
  std::vector<Reflection> reflections; // of each module, after specialisation
  std::vector<Binding> bindings;       // ordered by name; `binding_word` is meaningless here
};

// Compiles, specialises and checks the stages of a pipeline named `label`. Throws Error(internal)
// if a constant is in none of them, if a resource has no binding number of its own or a set other
// than 0 or is an array, if two stages disagree about a binding, or if the fragment stage reads
// what the vertex stage does not write.
//
// What was specialised in an earlier run comes from the cache directory (module_cache.h).
Program link(const std::string& label, std::span<const std::string> stages,
             std::span<const Constant> constants, Backend backend);

// Starts to link the same on another thread, of which there are no more than the machine has cores; link() then waits for what is
// under way. What is wrong is thrown there.
void link_ahead(const std::string& label, std::span<const std::string> stages,
                std::span<const Constant> constants, Backend backend);

} // namespace gg::gpu::shaders
