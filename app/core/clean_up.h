// The end of the process where no destructor runs.
#pragma once

#include "core/error.h"

namespace gg {

// Removes the temporaries of unfinished OutputFiles (core/files.h) and exits: in signal handlers, and where a library would end the
// process.
[[noreturn]] void clean_up_and_exit(ExitCode code);

} // namespace gg
