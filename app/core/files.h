// Files: reading whole, writing so that nothing half-written is left behind, and finding what ships
// with the program.
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace gg {

// The whole file. Throws Error(input) naming the path if it cannot be read, or is larger than
// `limit_bytes`.
std::vector<std::byte> read_file(const std::filesystem::path& path,
                                 std::size_t limit_bytes = std::size_t{4} << 30);
std::string read_text(const std::filesystem::path& path);

// A file that appears under its name only when it is complete: written to a temporary beside it and
// renamed by commit(); removed by the destructor if commit() was never reached, and by an interrupt
// (Ctrl-C).
class OutputFile {
public:
  // Makes the directories that are missing. Throws Error(output) if that or writing there is not possible.
  explicit OutputFile(const std::filesystem::path& path);
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  // The temporary, on the same file system and with the same extension: for libraries that open
  // files themselves.
  const std::filesystem::path& temporary() const { return temporary_; }
  // Appends to the temporary. Throws Error(output) on a full disk and the like.
  void write(std::span<const std::byte> bytes);
  void write(std::string_view text);
  // Makes the temporary the file. Throws Error(output).
  void commit();

private:
  // The directories that were missing. Its destructor removes those that are empty: all, if nothing
  // came of the file.
  struct MadeDirectories {
    std::vector<std::filesystem::path> inner_first;
    void make(const std::filesystem::path& directory, const std::filesystem::path& wanted_for);
    ~MadeDirectories();
  };
  MadeDirectories made_;
  std::filesystem::path path_, temporary_;
  int slot_ = -1; // in the list that the interrupt handler removes
};

// Removes the temporaries of unfinished OutputFiles and exits with ExitCode::interrupted on SIGINT
// and SIGTERM.
void clean_up_on_interrupt();

// The directory that holds shaders/ and assets/: $GROUNDGLASS_HOME if set, else the nearest one
// above the executable, else the source tree that the program was built from. Throws Error(input)
// if none has them.
const std::filesystem::path& home_directory();

} // namespace gg
