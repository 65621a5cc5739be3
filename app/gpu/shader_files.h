// The text of shaders/ while a program runs that draws with it.
#pragma once

#include "gpu/device.h"

#include <string>
#include <vector>

namespace gg::gpu {

// Every file that a stage may be made of.
std::vector<std::string> shader_files();

// Compiles again the stages whose text has changed since it was compiled: pipelines that are made from then on are of the new text.
// Throws Error, of the first that does not compile, with file, line and the compiler's words; all is as before then. Returns how
// many were compiled. From any thread; the first call takes the text that it finds as known.
int recompile_changed_shaders(Backend backend);

} // namespace gg::gpu
