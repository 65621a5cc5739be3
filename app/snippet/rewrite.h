// A snippet's GLSL, changed without a change of meaning.
#pragma once

#include <string>

namespace gg::snippet {

// Every name that the text declares at its outermost level (functions, structs, constants, macros, include guards) with `prefix`
// before it, wherever it is used. Comments stay.
std::string with_prefix(const std::string& text, const std::string& prefix);

// Without comments and empty lines.
std::string without_comments(const std::string& text);

// Without include guards: for a text that is whole and has a guard of its own.
std::string without_guards(const std::string& text);

} // namespace gg::snippet
