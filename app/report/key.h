// Names for contents: what a cached result depends on, as a number.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>

namespace gg::report {

// FNV-1a in 64 bits over everything added, in order. Texts are added with their length, so that
// ("ab", "c") and ("a", "bc") differ. Two of n different contents get the same key with a
// probability of n² / 2^65: 3e-12 for ten thousand.
class Key {
public:
  Key& add(std::span<const std::byte> bytes);
  Key& add(std::string_view text);
  Key& add(double value);
  std::string text() const; // 16 hexadecimal digits

private:
  void mix(std::span<const std::byte> bytes);
  std::uint64_t hash_ = 0xcbf29ce484222325ull;
};

// Of the file and of all that it refers to. Throws Error(input) if one is missing or is no glTF.
std::string key_of_gltf(const std::filesystem::path& path);
std::string key_of_file(const std::filesystem::path& path);
// Of all files below a directory, by name and content.
std::string key_of_tree(const std::filesystem::path& directory);

// Of what computes a truth (the texts that are compiled into it), and of what draws a frame (the
// running program, its shaders and its tables).
std::string key_of_truth_program();
const std::string& key_of_frame_program();

} // namespace gg::report
