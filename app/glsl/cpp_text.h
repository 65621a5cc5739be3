// Snippet text as C++: the same tokens but for three that the languages spell differently.
#pragma once

#include <string>

namespace gg::glsl {

// How a literal such as 0.5 is spelled so that it has the snippet's own precision and nothing is
// promoted to double.
enum class Literals {
  bare,     // 0.5        for Real = double
  suffixed, // 0.5f      for Real = float
  wrapped   // Real(0.5)  for a Real that is a class (half precision in the tests)
};

// `flattened` with `float` spelled Real, floating literals as asked, and `inline` before every
// function. The result goes into a namespace that holds glsl/shim.inl. Comments and preprocessor
// lines stay as they are.
std::string cpp_text(const std::string& flattened, Literals literals);

} // namespace gg::glsl
