// How the loader says that a file is wrong.
#pragma once

#include "core/error.h"

#include <string>

namespace gg::scene::gltf {

inline constexpr const char* export_again =
    "Export the file again, or look at it with the glTF validator.";

// Throws Error(input): "FILE: PLACE: WHAT. REMEDY", where `place` is written as in the file:
// "accessors[3].count".
[[noreturn]] inline void fail(const std::string& file, const std::string& place,
                              const std::string& what, const std::string& remedy = export_again) {
  throw Error(ExitCode::input, place.empty() ? file : file + ": " + place, what, remedy);
}

[[noreturn]] inline void fail_unsupported(const std::string& file, const std::string& place,
                                          const std::string& what, const std::string& remedy) {
  throw Error(ExitCode::unsupported, place.empty() ? file : file + ": " + place, what, remedy);
}

inline std::string element(const char* array, int index) {
  return std::string(array) + "[" + std::to_string(index) + "]";
}

} // namespace gg::scene::gltf
