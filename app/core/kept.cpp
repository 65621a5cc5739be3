#include "core/kept.h"

#include "core/cache_directory.h"
#include "core/error.h"
#include "core/files.h"
#include "core/sealed.h"

#include <algorithm>
#include <cstdio>
#include <mutex>
#include <set>

namespace gg {
namespace fs = std::filesystem;
namespace {

fs::path file_of(const Kept& kept, const std::string& key) {
  return *cache_directory() / kept.folder / (key + std::string(kept.extension));
}

// Once in the life of the process: a run stores few of all.
void forget_oldest(const fs::path& directory, std::size_t most_files) {
  static std::mutex mutex;
  static std::set<fs::path> tidied;
  {
    const std::lock_guard lock(mutex);
    if (!tidied.insert(directory).second) return;
  }
  std::vector<std::pair<fs::file_time_type, fs::path>> files;
  for (const fs::directory_entry& entry : fs::directory_iterator(directory))
    files.emplace_back(entry.last_write_time(), entry.path());
  if (files.size() <= most_files) return;
  std::ranges::sort(files);
  std::error_code ignored; // another process may have been first
  for (std::size_t i = 0; i + most_files / 2 < files.size(); ++i)
    fs::remove(files[i].second, ignored);
}

} // namespace

void KeyHash::add(std::span<const std::byte> bytes) {
  for (std::uint64_t& half : halves_)
    half = checksum(bytes, half);
}

std::string KeyHash::text() const {
  std::array<char, 33> digits;
  std::snprintf(digits.data(), digits.size(), "%016llx%016llx",
                static_cast<unsigned long long>(halves_[0]),
                static_cast<unsigned long long>(halves_[1]));
  return digits.data();
}

std::string program_identity() {
  std::error_code none;
  const fs::path program = fs::read_symlink("/proc/self/exe", none);
  return program.string() + ' ' + std::to_string(fs::file_size(program, none)) + ' '
         + std::to_string(fs::last_write_time(program, none).time_since_epoch().count());
}

bool Kept::possible() const {
  return cache_directory().has_value();
}

std::optional<std::vector<std::byte>> Kept::load(const std::string& key) const {
  if (!possible()) return std::nullopt;
  const fs::path file = file_of(*this, key);
  std::error_code ignored;
  if (!fs::is_regular_file(file, ignored)) return std::nullopt;
  try {
    auto data = unseal(read_file(file, largest_file), magic);
    if (data) fs::last_write_time(file, fs::file_time_type::clock::now(), ignored);
    return data;
  } catch (const Error&) {
    return std::nullopt;
  }
}

void Kept::store(const std::string& key, std::span<const std::byte> data) const noexcept {
  try {
    if (!possible()) return;
    const fs::path path = file_of(*this, key);
    OutputFile file(path);
    file.write(std::span<const std::byte>(seal(data, magic)));
    file.commit();
    forget_oldest(path.parent_path(), most_files);
  } catch (const std::exception&) {
    // A full disk or a read-only home: nothing that a picture depends on.
  }
}

} // namespace gg
