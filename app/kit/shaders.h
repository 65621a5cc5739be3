// The kit's shaders, whole: each file compiles as it is for the target.
#pragma once

#include "kit/kit.h"

#include <filesystem>

namespace gg::kit {

// assets/kit/shaders/*.vert and *.frag into directory/shaders: behind the target's first lines, with what they #include, and for
// `#snippets NAMES` those snippets, flattened, under the prefix gg_. Throws Error(output).
void write_shaders(Target target, const std::filesystem::path& home,
                   const std::filesystem::path& directory);

} // namespace gg::kit
