// A scene as the options give it, to be measured.
#pragma once

#include "commands/options.h"
#include "report/subject.h"

namespace gg::commands {

// Reads the files once for their key; they are loaded when they are needed. Throws Error if a file
// is missing or an option is not understood.
report::Subject subject_of(const SceneOptions& options, const std::string& smith,
                           bool multiscatter);

} // namespace gg::commands
