#include "core/files.h"

#include "core/error.h"

#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <random>

namespace gg {
namespace fs = std::filesystem;
namespace {

// Paths that an interrupt has to remove. A signal handler may only touch lock-free atomics and call
// unlink, so the list is fixed: more than 16 files being written at once is not something any
// command does.
std::array<std::atomic<char*>, 16> unfinished{};

int remember(const fs::path& path) {
  char* text = ::strdup(path.c_str());
  for (std::size_t i = 0; i < unfinished.size(); ++i) {
    char* empty = nullptr;
    if (unfinished[i].compare_exchange_strong(empty, text)) return static_cast<int>(i);
  }
  std::free(text);
  return -1;
}

void forget(int slot) {
  if (slot >= 0) std::free(unfinished[static_cast<std::size_t>(slot)].exchange(nullptr));
}

void on_interrupt(int) {
  for (auto& path : unfinished)
    if (const char* text = path.load()) ::unlink(text);
  ::_exit(static_cast<int>(ExitCode::interrupted));
}

std::string reason() {
  return std::strerror(errno);
}

bool is_home(const fs::path& directory) {
  std::error_code ignored;
  return fs::is_directory(directory / "shaders", ignored)
         && fs::is_directory(directory / "assets", ignored);
}

fs::path find_home() {
  if (const char* chosen = std::getenv("GROUNDGLASS_HOME")) {
    if (is_home(chosen)) return chosen;
    throw Error(ExitCode::input, chosen, "has no shaders/ and assets/",
                "Set GROUNDGLASS_HOME to the directory that holds both, or unset it.");
  }
  std::error_code error;
  for (fs::path up = fs::read_symlink("/proc/self/exe", error).parent_path(); !error;) {
    if (is_home(up)) return up;
    if (up == up.parent_path()) break;
    up = up.parent_path();
  }
  if (is_home(GROUNDGLASS_SOURCE_DIR)) return GROUNDGLASS_SOURCE_DIR;
  throw Error(ExitCode::input, "groundglass", "cannot find its shaders/ and assets/",
              "Set GROUNDGLASS_HOME to the directory that holds both.");
}

} // namespace

std::vector<std::byte> read_file(const fs::path& path, std::size_t limit_bytes) {
  std::error_code error;
  if (fs::is_directory(path, error))
    throw Error(ExitCode::input, path, "is a directory", "Name a file.");
  const std::uintmax_t size = fs::file_size(path, error);
  if (error)
    throw Error(ExitCode::input, path, "cannot be read: " + error.message(),
                "Check the path and its permissions.");
  if (size > limit_bytes)
    throw Error(ExitCode::input, path,
                "is " + std::to_string(size) + " bytes, more than the "
                    + std::to_string(limit_bytes) + " that are accepted");
  std::vector<std::byte> bytes(static_cast<std::size_t>(size));
  std::ifstream in(path, std::ios::binary);
  if (!in
      || !in.read(reinterpret_cast<char*>(bytes.data()),
                  static_cast<std::streamsize>(bytes.size())))
    throw Error(ExitCode::input, path, "cannot be read: " + reason(),
                "Check the path and its permissions.");
  return bytes;
}

std::string read_text(const fs::path& path) {
  const std::vector<std::byte> bytes = read_file(path);
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

OutputFile::OutputFile(const fs::path& path) : path_(path) {
  std::error_code ignored;
  if (fs::is_directory(path, ignored))
    throw Error(ExitCode::output, path, "is a directory", "Name a file to write.");
  made_.make(path.parent_path(), path);
  fs::path stem = path;
  stem.replace_extension();
  for (std::random_device random;;) {
    temporary_ = stem;
    temporary_ += ".partial-" + std::to_string(random()) + path.extension().string();
    const int file = ::open(temporary_.c_str(), O_CREAT | O_EXCL | O_WRONLY | O_CLOEXEC, 0666);
    if (file >= 0) {
      ::close(file);
      break;
    }
    if (errno != EEXIST)
      throw Error(ExitCode::output, path, "cannot be written: " + reason(),
                  "Check that its directory exists and that you may write there.");
  }
  slot_ = remember(temporary_);
}

void OutputFile::MadeDirectories::make(const fs::path& directory, const fs::path& wanted_for) {
  std::error_code error;
  std::vector<fs::path> missing;
  for (fs::path up = directory; !up.empty() && !fs::exists(up, error); up = up.parent_path())
    missing.push_back(up);
  for (; !missing.empty(); missing.pop_back()) {
    fs::create_directory(missing.back(), error);
    if (error)
      throw Error(ExitCode::output, wanted_for,
                  "cannot be written: " + missing.back().string() + ": " + error.message(),
                  "Choose a place where you may write.");
    inner_first.insert(inner_first.begin(), missing.back());
  }
}

OutputFile::MadeDirectories::~MadeDirectories() {
  std::error_code ignored; // not empty: something was written
  for (const fs::path& directory : inner_first)
    fs::remove(directory, ignored);
}

OutputFile::~OutputFile() {
  if (!temporary_.empty()) {
    std::error_code ignored;
    fs::remove(temporary_, ignored);
  }
  forget(slot_);
}

void OutputFile::write(std::span<const std::byte> bytes) {
  std::ofstream out(temporary_, std::ios::binary | std::ios::app);
  out.write(reinterpret_cast<const char*>(bytes.data()),
            static_cast<std::streamsize>(bytes.size()));
  out.flush();
  if (!out)
    throw Error(ExitCode::output, path_, "cannot be written: " + reason(),
                "Check the space left on the disk.");
}

void OutputFile::write(std::string_view text) {
  write(std::as_bytes(std::span(text)));
}

void OutputFile::commit() {
  std::error_code error;
  fs::rename(temporary_, path_, error);
  if (error)
    throw Error(ExitCode::output, path_, "cannot be written: " + error.message(),
                "Check that you may write there.");
  temporary_.clear();
}

void clean_up_on_interrupt() {
  std::signal(SIGINT, on_interrupt);
  std::signal(SIGTERM, on_interrupt);
}

const fs::path& home_directory() {
  static const fs::path home = find_home();
  return home;
}

} // namespace gg
