// What the program works out once and keeps between runs: a file per key, in a folder of the cache directory.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace gg {

// Two checksums of different starts: 128 bits, so that no two of what was ever seen agree by chance.
class KeyHash {
public:
  void add(std::span<const std::byte> bytes);
  void add(std::string_view text) { add(std::as_bytes(std::span(text.data(), text.size()))); }
  std::string text() const; // 32 digits

private:
  std::array<std::uint64_t, 2> halves_{0xcbf29ce484222325ull, 0x84222325cbf29ce4ull};
};

// Another one for each build of the program: of a key whose values change with the code that makes them.
std::string program_identity();

// Functions of one kind of such files. None throws for what a disk or other processes do: then the next run works it out again.
struct Kept {
  std::string_view folder;    // in cache_directory()
  std::string_view extension; // ".spv"
  std::string_view magic;     // 8 characters: changes with what is in the files
  std::size_t most_files;     // past this many the half that was used longest ago goes
  std::size_t largest_file;   // keeps a wrong file from filling memory

  bool possible() const; // false: there is no cache directory
  // Nothing if it is not there; what is damaged or of another version counts as not there.
  std::optional<std::vector<std::byte>> load(const std::string& key) const;
  void store(const std::string& key, std::span<const std::byte> data) const noexcept;
};

} // namespace gg
