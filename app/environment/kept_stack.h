// Stacks of cubes kept between runs: prefiltering is most of the time to a first picture.
#pragma once

#include "environment/stack.h"

#include <optional>
#include <string>

namespace gg::environment {

// What a stack's bytes depend on: the pixels of the fitted map, this build of the program, the text of the stages, and the device
// with its driver, which round. Nothing for maps that take no time, and where nothing can be kept.
std::optional<std::string> key_of_stack(const gpu::Device& device, const Map& map);

// Fills the cubes. False, and their texels as they were, if no such stack is kept, or not whole.
bool load_stack(gpu::Device& device, const std::string& key, const Stack& stack);
// Waits for the device. Where it cannot be kept the next run works it out again, nothing more.
void store_stack(gpu::Device& device, const std::string& key, const Stack& stack);

} // namespace gg::environment
