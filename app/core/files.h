// Files: reading whole, writing so that nothing half-written is left behind, and finding what ships
// with the program.
#pragma once

#include <cstddef>
#include <filesystem>
#include <initializer_list>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace gg {

// The whole file; "-" is standard input. Throws Error(input) naming the path if it cannot be read, or
// is larger than `limit_bytes`.
std::vector<std::byte> read_file(const std::filesystem::path& path,
                                 std::size_t limit_bytes = std::size_t{4} << 30);
std::string read_text(const std::filesystem::path& path);

// Where an output goes. "-" is standard output. A symbolic link is followed. What is not a regular
// file (a device, a pipe) and what leads to standard output or standard error by another name is a stream: it is written
// to and never replaced.
struct Destination {
  std::filesystem::path path; // links followed; of a stream as it was given
  bool is_stream = false;
  int descriptor = -1; // of a stream that is open already
};
Destination destination_of(const std::filesystem::path& path);

// Throws Error(usage) if two of the paths that are not empty lead to one place, where one result would overwrite the other
// (any number may go to /dev/null).
void refuse_same_output(std::initializer_list<std::filesystem::path> paths);

// A file that appears under its name only when it is complete: written to a temporary beside it and
// renamed by commit(); removed by the destructor if commit() was never reached, and by an interrupt
// (Ctrl-C). To a stream everything is written by commit().
class OutputFile {
public:
  // Makes the directories that are missing. Throws Error(output) if that or writing there is not possible.
  explicit OutputFile(const std::filesystem::path& path);
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  // Appends. Throws Error(output) on a full disk and the like.
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
  Destination destination_;
  std::vector<std::byte> held_; // for a stream
  int slot_ = -1;               // in the list that the interrupt handler removes
};

// Removes the temporaries of unfinished OutputFiles and exits with ExitCode::interrupted on SIGINT
// and SIGTERM.
void clean_up_on_interrupt();

// The directory that holds shaders/ and assets/: $GROUNDGLASS_HOME if set, else the nearest one
// above the executable or its share/groundglass (as installed), else the source tree that the
// program was built from. Throws Error(input) if none has them.
const std::filesystem::path& home_directory();

} // namespace gg
