// Shader text taken apart: the declarations at its outermost level. For GLSL as snippets are written, and for the HLSL, MSL and WGSL
// that converters make of it.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace gg::snippet {

struct Token {
  std::size_t begin = 0, end = 0; // bytes of the text
  int depth = 0;                  // of braces, brackets and parentheses around it
};

// Words, numbers and single characters of punctuation, without white space, comments and preprocessor lines.
std::vector<Token> tokens(const std::string& text);

struct Parameter {
  std::size_t begin = 0; // where it is declared
  std::string type, name;
};

struct Item {
  enum class Kind { function, prototype, structure, constant, other };
  Kind kind = Kind::other;
  std::string type; // of a function's result or a constant
  std::string name;
  std::vector<Parameter> parameters;
  std::size_t begin = 0, header_end = 0,
              end = 0; // header_end: past a function's closing parenthesis
};

// The declarations of `text`, in order. Text that no compiler takes gives items that mean nothing, and no error.
std::vector<Item> items(const std::string& text);

bool is_word(const std::string& text, const Token& token);

} // namespace gg::snippet
