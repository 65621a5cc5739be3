#include "gpu/shaders/module_cache.h"

#include "core/cache_directory.h"
#include "core/error.h"
#include "core/files.h"
#include "core/sealed.h"
#include "glsl/includes.h"
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

// The text of a stage with every file that it may include, whatever its conditions say.
class HashedText final : public glsl::IncludeWalk {
public:
  explicit HashedText(const fs::path& stage) { walk(stage); }
  std::string hash() const { return hash_.text(); }

private:
  fs::path find(const std::string& name, const Place& from) override {
    return find_include(name, from.file).value_or(fs::path());
  }
  void text(std::string_view line, const Place&) override {
    hash_.add(line);
    hash_.add("\n");
  }

  Hash hash_;
};

// What the process keeps.
struct Texts {
  std::mutex mutex;
  std::map<fs::path, std::string> hashes;
  std::set<fs::path> tidied; // cache folders
};

Texts& texts() {
  static Texts all;
  return all;
}

std::optional<fs::path> folder() {
  auto directory = cache_directory();
  if (directory) *directory /= "shaders";
  return directory;
}

// Once in the life of the process: a run stores a few hundred at most.
void forget_oldest(const fs::path& directory) {
  {
    const std::lock_guard lock(texts().mutex);
    if (!texts().tidied.insert(directory).second) return;
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

std::string text_hash(const fs::path& file) {
  const std::lock_guard lock(texts().mutex);
  std::string& text = texts().hashes[file];
  if (text.empty()) text = HashedText(file).hash();
  return text;
}

std::string text_hash_on_disk(const fs::path& file) {
  return HashedText(file).hash();
}

void remember_text_hashes(const std::map<fs::path, std::string>& hashes) {
  const std::lock_guard lock(texts().mutex);
  for (const auto& [file, hash] : hashes)
    texts().hashes[file] = hash;
}

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
