#include "gpu/shaders/module_cache.h"

#include "core/error.h"
#include "core/kept.h"
#include "glsl/includes.h"
#include "gpu/shaders/compile.h"
#include "gpu/shaders/includes.h"

#include <glslang/Public/ShaderLang.h>
#include <spirv-tools/libspirv.h>

#include <cstring>
#include <map>
#include <mutex>

namespace gg::gpu::shaders {
namespace fs = std::filesystem;
namespace {

// All bundled scenes by all methods make about 300 modules; the largest is a quarter of a megabyte. The magic changes with the way in
// which modules are made from their text, which the key does not see.
constexpr Kept kept{.folder = "shaders",
                    .extension = ".spv",
                    .magic = "ggspirv1",
                    .most_files = 1000,
                    .largest_file = std::size_t{16} << 20};

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

  KeyHash hash_;
};

// What the process keeps.
struct Texts {
  std::mutex mutex;
  std::map<fs::path, std::string> hashes;
};

Texts& texts() {
  static Texts all;
  return all;
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
  if (!kept.possible()) return std::nullopt;
  KeyHash hash;
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
  const auto bytes = kept.load(key);
  if (!bytes || bytes->size() % sizeof(std::uint32_t) != 0) return std::nullopt;
  const fs::path path = stage_path(stage_file);
  Module module{display_name(path), stage_of(path), {}};
  module.words.resize(bytes->size() / sizeof(std::uint32_t));
  std::memcpy(module.words.data(), bytes->data(), bytes->size());
  return module;
}

void store_module(const std::string& key, const Module& module) noexcept {
  kept.store(key, std::as_bytes(std::span(module.words)));
}

} // namespace gg::gpu::shaders
