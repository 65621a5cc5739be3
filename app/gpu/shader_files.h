// The text of shaders/ while a program runs that draws with it.
#pragma once

#include "gpu/device.h"

#include <string>
#include <vector>

namespace gg::gpu {

// Every file that a stage may be made of.
std::vector<std::string> shader_files();

// Of the text of a stage with all that it includes, as the process first read it: 32 digits. Throws Error(input) if it cannot be read.
std::string shader_text_hash(const std::string& stage_file);

// Compiles again the stages whose text has changed since it was compiled: pipelines that are made from then on are of the new text.
// Throws Error, of the first that does not compile, with file, line and the compiler's words; all is as before then. Returns how
// many were compiled. From any thread; the first call takes the text that it finds as known.
int recompile_changed_shaders(Backend backend);

} // namespace gg::gpu
