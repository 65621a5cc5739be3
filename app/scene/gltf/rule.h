// A table language for what a JSON object must hold.
#pragma once

#include <cfloat>
#include <span>

namespace gg::scene::gltf {

enum class Kind {
  boolean,
  string,
  choice,  // a string out of a list
  integer, // low..high
  number,  // low..high
  numbers, // an array of `size` numbers (0: any length), each low..high
  strings, // an array of strings
  index,   // a place in the array `target`
  indices, // an array of such
  object,  // an object with `members`
  objects, // an array of such objects
  map,     // an object whose values are all indices into `target`, whatever the keys; without a
           // target, whole numbers low..high
  maps     // an array of such maps
};

// The largest whole number that JSON passes on unharmed in every program: 2^53.
inline constexpr double largest_integer = 9007199254740992.0;

// Factors that the specification confines to 0..1 (components of quaternions to -1..1). Writers round, to 32-bit floats or to
// a few decimals, so 1 may come back as 1.0000021 or 1.001: taken as 1, with a note. What reads them clamps.
inline constexpr double factor = 1.001;

struct Rule {
  const char* key;
  Kind kind;
  bool required = false;
  double low = -FLT_MAX, high = FLT_MAX; // inclusive; values become 32-bit floats
  std::size_t size = 0;
  const char* target = nullptr; // a JSON pointer, or the words of a choice separated by spaces
  std::span<const Rule> members{};
};

// The rules of the whole file, in schema.cpp.
std::span<const Rule> schema();
// Of an entry of "animations", which the rules of the file leave out.
std::span<const Rule> animation_rules();

} // namespace gg::scene::gltf
