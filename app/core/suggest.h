// What was probably meant by a name that does not exist.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace gg {

// The name nearest to `word` by Damerau-Levenshtein distance (a letter changed, left out, put in, or
// two swapped count 1 each; case counts only between names as near), or the first that `word` begins;
// empty if none is within a third of the word's length.
std::string nearest(std::string_view word, std::span<const std::string> names);

// "Did you mean NAME? " or nothing: to be put before the remedy of an Error.
std::string did_you_mean(std::string_view word, std::span<const std::string> names);

} // namespace gg
