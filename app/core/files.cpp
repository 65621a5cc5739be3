#include "core/files.h"

#include "core/clean_up.h"
#include "core/error.h"
#include "core/suggest.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <map>
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
  clean_up_and_exit(ExitCode::interrupted);
}

std::string reason() {
  return std::strerror(errno);
}

// "Did you mean FILE? " of the files beside one that does not exist, or nothing.
std::string meant(const fs::path& path) {
  constexpr std::size_t most = 4096; // names looked at: milliseconds in any folder
  std::vector<std::string> names;
  std::error_code ignored;
  for (fs::directory_iterator i(path.has_parent_path() ? path.parent_path() : ".", ignored), end;
       !ignored && i != end && names.size() < most; i.increment(ignored))
    names.push_back(i->path().filename().string());
  std::ranges::sort(names); // the same answer whatever the order in the folder
  return did_you_mean(path.filename().string(), names);
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
    if (is_home(up / "share" / "groundglass")) return up / "share" / "groundglass"; // installed
    if (up == up.parent_path()) break;
    up = up.parent_path();
  }
  if (is_home(GROUNDGLASS_SOURCE_DIR)) return GROUNDGLASS_SOURCE_DIR;
  throw Error(ExitCode::input, "groundglass", "cannot find its shaders/ and assets/",
              "Set GROUNDGLASS_HOME to the directory that holds both.");
}

std::string name_of_input(const fs::path& path) {
  return path == "-" ? "standard input" : path.string();
}

// Pipes and devices do not say how much they hold.
std::vector<std::byte> read_stream(const fs::path& path, std::size_t limit_bytes) {
  const std::string name = name_of_input(path);
  const int file = path == "-" ? STDIN_FILENO : ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  std::vector<std::byte> bytes;
  constexpr std::size_t step = std::size_t{1} << 20;
  ssize_t got = file < 0 ? -1 : 1;
  while (got > 0 && bytes.size() <= limit_bytes) {
    const std::size_t at = bytes.size();
    bytes.resize(at + step);
    do
      got = ::read(file, bytes.data() + at, step);
    while (got < 0 && errno == EINTR);
    bytes.resize(at + static_cast<std::size_t>(std::max<ssize_t>(got, 0)));
  }
  const std::string why = reason();
  if (file > STDIN_FILENO) ::close(file);
  if (got < 0)
    throw Error(ExitCode::input, name, "cannot be read: " + why,
                "Check the path and its permissions.");
  if (bytes.size() > limit_bytes)
    throw Error(ExitCode::input, name,
                "has more than the " + std::to_string(limit_bytes) + " bytes that are accepted");
  return bytes;
}

struct Followed {
  fs::path end; // where a chain of links ends, whether or not anything is there
  bool through_device = false;
};

Followed follow(fs::path path) {
  std::error_code error;
  Followed way;
  const auto look = [&] {
    const std::string text = fs::absolute(path, error).lexically_normal().string();
    way.through_device |= text.starts_with("/dev/") || text.starts_with("/proc/");
  };
  look();
  for (int links = 0; links < 40 && fs::is_symlink(path, error); ++links) {
    path = path.parent_path() / fs::read_symlink(path, error);
    look();
  }
  way.end = path;
  return way;
}

bool same_file(const struct stat& a, const struct stat& b) {
  return a.st_dev == b.st_dev && a.st_ino == b.st_ino;
}

void write_all(int file, std::span<const std::byte> bytes, const fs::path& path) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(file, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0)
      throw Error(ExitCode::output, path, "cannot be written: " + reason(), "Check what reads it.");
    bytes = bytes.subspan(static_cast<std::size_t>(written));
  }
}

} // namespace

std::vector<std::byte> read_file(const fs::path& path, std::size_t limit_bytes) {
  std::error_code error;
  if (fs::is_directory(path, error))
    throw Error(ExitCode::input, path, "is a directory", "Name a file.");
  if (path == "-" || (fs::exists(path, error) && !fs::is_regular_file(path, error)))
    return read_stream(path, limit_bytes);
  const std::uintmax_t size = fs::file_size(path, error);
  if (error)
    throw Error(ExitCode::input, path, "cannot be read: " + error.message(),
                meant(path) + "Check the path and its permissions.");
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

Destination destination_of(const fs::path& path) {
  if (path == "-") return {.path = path, .is_stream = true, .descriptor = STDOUT_FILENO};
  const Followed way = follow(path);
  struct stat there {};
  if (::stat(path.c_str(), &there) != 0) return {.path = way.end};
  if (S_ISDIR(there.st_mode)) return {.path = path};
  // The names of open files are links in /dev and /proc, and standard output may be a regular file.
  if (S_ISREG(there.st_mode) && !way.through_device) return {.path = way.end};
  for (const int descriptor : {STDOUT_FILENO, STDERR_FILENO})
    if (struct stat open{}; ::fstat(descriptor, &open) == 0 && same_file(there, open))
      return {.path = path, .is_stream = true, .descriptor = descriptor};
  return {.path = path, .is_stream = true};
}

void refuse_same_output(std::initializer_list<fs::path> paths) {
  const auto is_null = [](const fs::path& path) {
    struct stat there {
    }, null{};
    return ::stat(path.c_str(), &there) == 0 && ::stat("/dev/null", &null) == 0
           && there.st_rdev == null.st_rdev && S_ISCHR(there.st_mode);
  };
  const auto key_of = [](const fs::path& path) {
    const Destination d = destination_of(path);
    if (d.descriptor >= 0) return "descriptor " + std::to_string(d.descriptor);
    std::error_code error;
    const fs::path whole = fs::weakly_canonical(fs::absolute(d.path, error), error);
    return whole.string();
  };
  std::map<std::string, fs::path> taken;
  for (const fs::path& path : paths) {
    if (path.empty() || is_null(path)) continue;
    const auto [other, is_new] = taken.emplace(key_of(path), path);
    if (!is_new)
      throw Error(ExitCode::usage, path,
                  other->second == path ? "is to hold two results"
                                        : "is the same place as " + other->second.string()
                                              + ", and both are to be written",
                  "Give each result a file of its own.");
  }
}

OutputFile::OutputFile(const fs::path& path) : path_(path), destination_(destination_of(path)) {
  std::error_code ignored;
  if (fs::is_directory(path, ignored))
    throw Error(ExitCode::output, path, "is a directory", "Name a file to write.");
  if (destination_.is_stream) {
    if (destination_.descriptor < 0 && ::access(path.c_str(), W_OK) != 0)
      throw Error(ExitCode::output, path, "cannot be written: " + reason(),
                  "Check that you may write there.");
    return;
  }
  made_.make(destination_.path.parent_path(), path);
  fs::path stem = destination_.path;
  stem.replace_extension();
  for (std::random_device random;;) {
    temporary_ = stem;
    temporary_ += ".partial-" + std::to_string(random()) + destination_.path.extension().string();
    const int file = ::open(temporary_.c_str(), O_CREAT | O_EXCL | O_WRONLY | O_CLOEXEC, 0666);
    if (file >= 0) {
      ::close(file);
      break;
    }
    if (errno != EEXIST) {
      const std::string why = reason();
      temporary_.clear(); // nothing of that name is ours
      throw Error(ExitCode::output, path, "cannot be written: " + why,
                  "Check that its directory exists and that you may write there.");
    }
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
  if (destination_.is_stream) {
    held_.insert(held_.end(), bytes.begin(), bytes.end());
    return;
  }
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
  if (destination_.is_stream) {
    std::fflush(stdout); // what was printed before comes before
    const bool is_open = destination_.descriptor >= 0;
    const int file =
        is_open ? destination_.descriptor : ::open(path_.c_str(), O_WRONLY | O_CLOEXEC);
    if (file < 0)
      throw Error(ExitCode::output, path_, "cannot be written: " + reason(),
                  "Check that you may write there.");
    try {
      write_all(file, held_, path_);
    } catch (...) {
      if (!is_open) ::close(file);
      throw;
    }
    if (!is_open) ::close(file);
    held_.clear();
    return;
  }
  std::error_code error;
  fs::rename(temporary_, destination_.path, error);
  if (error)
    throw Error(ExitCode::output, path_, "cannot be written: " + error.message(),
                "Check that you may write there.");
  temporary_.clear();
}

void clean_up_and_exit(ExitCode code) {
  for (auto& path : unfinished)
    if (const char* text = path.load()) ::unlink(text);
  ::_exit(static_cast<int>(code));
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
