#include "gpu/shaders/module_cache.h"

#include "core/cache_directory.h"
#include "core/error.h"
#include "core/files.h"
#include "core/sealed.h"
#include "gpu/shaders/compile.h"
#include "gpu/shaders/includes.h"

#include <glslang/Public/ShaderLang.h>
#include <spirv-tools/libspirv.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstring>
#include <map>
#include <mutex>
#include <set>

namespace gg::gpu::shaders {
namespace fs = std::filesystem;
namespace {

// Changes with the way in which modules are made from their text, which the key does not see.
constexpr std::string_view magic = "ggspirv1";
// The largest stage is a quarter of a megabyte; keeps a wrong file from filling memory.
constexpr std::size_t largest_file = std::size_t{16} << 20;
// All bundled scenes by all methods make about 300. Past this many the oldest go.
constexpr std::size_t most_files = 1000;

// Two checksums of different starts: 128 bits, so that no two of the texts ever seen agree by chance.
class Hash {
public:
  void add(std::string_view text) {
    const auto bytes = std::as_bytes(std::span(text.data(), text.size()));
    for (std::uint64_t& half : halves_)
      half = checksum(bytes, half);
  }
  std::string text() const {
    std::array<char, 33> digits;
    std::snprintf(digits.data(), digits.size(), "%016llx%016llx",
                  static_cast<unsigned long long>(halves_[0]),
                  static_cast<unsigned long long>(halves_[1]));
    return digits.data();
  }

private:
  std::array<std::uint64_t, 2> halves_{0xcbf29ce484222325ull, 0x84222325cbf29ce4ull};
};

// The file of an `#include "x"` line, or nothing.
std::optional<fs::path> included(std::string_view line, const fs::path& from) {
  constexpr std::string_view directive = "#include";
  const std::size_t start = line.find_first_not_of(" \t");
  if (start == std::string_view::npos || !line.substr(start).starts_with(directive))
    return std::nullopt;
  const std::size_t open = line.find('"', start), close = line.find('"', open + 1);
  if (open == std::string_view::npos || close == std::string_view::npos) return std::nullopt;
  return find_include(std::string(line.substr(open + 1, close - open - 1)), from);
}

// The text of a file and, at first mention, of the files that it includes, whatever its conditions say.
void add_text(const fs::path& file, std::set<fs::path>& seen, Hash& hash) {
  if (!seen.insert(file).second) return;
  const std::string text = read_text(file);
  hash.add(text);
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    if (const auto next = included(std::string_view(text).substr(at, end - at), file))
      add_text(*next, seen, hash);
    at = end + 1;
  }
}

struct Texts {
  std::mutex mutex;
  std::map<fs::path, std::string> hashes;
};

Texts& texts() {
  static Texts all;
  return all;
}

// Read once in the life of the process, as compile() does.
std::string text_hash(const fs::path& file) {
  const std::lock_guard lock(texts().mutex);
  std::string& text = texts().hashes[file];
  if (text.empty()) {
    Hash hash;
    std::set<fs::path> seen;
    add_text(file, seen, hash);
    text = hash.text();
  }
  return text;
}

std::optional<fs::path> folder() {
  auto directory = cache_directory();
  if (directory) *directory /= "shaders";
  return directory;
}

void forget_oldest(const fs::path& directory) {
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

void keep_keys() {
  texts();
}

std::optional<std::string> module_key(std::string_view stage_file,
                                      std::span<const Constant> constants, Backend backend) {
  if (!folder()) return std::nullopt;
  Hash hash;
  try {
    hash.add(text_hash(stage_path(stage_file)));
  } catch (const Error&) {
    return std::nullopt; // compile() says what is wrong with it
  }
  hash.add(backend == Backend::vulkan ? "vulkan" : "opengl");
  hash.add(glslang::GetGlslVersionString());
  hash.add(spvSoftwareVersionDetailsString());
  for (const Constant& constant : constants)
    hash.add(std::to_string(constant.id) + "=" + std::to_string(constant.bits) + ";");
  return hash.text();
}

std::optional<Module> load_module(const std::string& key, std::string_view stage_file) {
  const fs::path file = *folder() / (key + ".spv");
  std::error_code ignored;
  if (!fs::is_regular_file(file, ignored)) return std::nullopt;
  try {
    const auto bytes = unseal(read_file(file, largest_file), magic);
    if (!bytes || bytes->size() % sizeof(std::uint32_t) != 0) return std::nullopt;
    const fs::path path = stage_path(stage_file);
    Module module{display_name(path), stage_of(path), {}};
    module.words.resize(bytes->size() / sizeof(std::uint32_t));
    std::memcpy(module.words.data(), bytes->data(), bytes->size());
    return module;
  } catch (const Error&) {
    return std::nullopt;
  }
}

void store_module(const std::string& key, const Module& module) noexcept {
  try {
    const fs::path directory = *folder();
    OutputFile file(directory / (key + ".spv"));
    file.write(std::span<const std::byte>(seal(std::as_bytes(std::span(module.words)), magic)));
    file.commit();
    forget_oldest(directory);
  } catch (const std::exception&) {
    // A full disk or a read-only home: nothing that a picture depends on.
  }
}

} // namespace gg::gpu::shaders
