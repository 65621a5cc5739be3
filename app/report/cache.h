// Results kept from run to run, each under the key of what it depends on.
#pragma once

#include <nlohmann/json.hpp>

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace gg::report {

// One directory; a result is a file KIND-KEY.EXT in it, complete or not there. Who deletes the
// directory loses time, nothing else.
class Cache {
public:
  // Makes the directory. Throws Error(output) if that is not possible.
  explicit Cache(const std::filesystem::path& directory);

  std::filesystem::path path(const std::string& kind, const std::string& key,
                             const std::string& extension) const;
  bool has(const std::string& kind, const std::string& key, const std::string& extension) const;

  // Nothing if it is not there or is not JSON: a damaged result is computed again.
  std::optional<nlohmann::json> json(const std::string& kind, const std::string& key) const;
  void store(const std::string& kind, const std::string& key, const nlohmann::json& value) const;

  std::optional<std::vector<std::byte>> bytes(const std::string& kind, const std::string& key,
                                              const std::string& extension) const;
  void store(const std::string& kind, const std::string& key, const std::string& extension,
             const std::vector<std::byte>& bytes) const;

private:
  std::filesystem::path directory_;
};

// Makes a directory and its parents. Throws Error(output) naming it.
void make_directory(const std::filesystem::path& directory);

} // namespace gg::report
