// A whole fragment shader around a snippet: what a converter or an optimiser needs to see of it.
#pragma once

#include "snippet/scan.h"

#include <string>

namespace gg::snippet {

// Every function of the text is called once, with arguments that mean nothing, so that none is left out as unused; functions that
// are only declared get a body that returns nothing of meaning. Parameters that a body does not change are made `const`, which
// SPIR-V passes by value.
std::string calling_all(const std::string& glsl);

// One function, its arguments from a buffer and its result into one, so that nothing of it can be left out.
std::string calling_one(const std::string& glsl, const Item& function);

} // namespace gg::snippet
