#include "report/cache.h"

#include "core/error.h"
#include "core/files.h"

namespace gg::report {

namespace fs = std::filesystem;

void make_directory(const fs::path& directory) {
  std::error_code error;
  fs::create_directories(directory, error);
  if (error || !fs::is_directory(directory, error))
    throw Error(ExitCode::output, directory, "cannot be made a directory",
                "Choose another name, or a place where you may write.");
}

Cache::Cache(const fs::path& directory) : directory_(directory) {
  make_directory(directory);
}

fs::path Cache::path(const std::string& kind, const std::string& key,
                     const std::string& extension) const {
  return directory_ / (kind + "-" + key + "." + extension);
}

bool Cache::has(const std::string& kind, const std::string& key,
                const std::string& extension) const {
  std::error_code ignored;
  return fs::is_regular_file(path(kind, key, extension), ignored);
}

std::optional<nlohmann::json> Cache::json(const std::string& kind, const std::string& key) const {
  if (!has(kind, key, "json")) return std::nullopt;
  auto value = nlohmann::json::parse(read_text(path(kind, key, "json")), nullptr, false);
  if (value.is_discarded()) return std::nullopt;
  return value;
}

void Cache::store(const std::string& kind, const std::string& key,
                  const nlohmann::json& value) const {
  OutputFile file(path(kind, key, "json"));
  file.write(value.dump(1) + "\n");
  file.commit();
}

std::optional<std::vector<std::byte>> Cache::bytes(const std::string& kind, const std::string& key,
                                                   const std::string& extension) const {
  if (!has(kind, key, extension)) return std::nullopt;
  return read_file(path(kind, key, extension));
}

void Cache::store(const std::string& kind, const std::string& key, const std::string& extension,
                  const std::vector<std::byte>& bytes) const {
  OutputFile file(path(kind, key, extension));
  file.write(bytes);
  file.commit();
}

} // namespace gg::report
