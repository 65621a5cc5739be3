#include "commands/json_file.h"

#include "core/files.h"

#include <nlohmann/json.hpp>

namespace gg::commands {

void check_json(const std::string& path) {
  if (!path.empty()) OutputFile probe(path);
}

void write_json(const std::string& path, nlohmann::json document) {
  document["schema"] = json_schema;
  OutputFile file(path);
  file.write(document.dump(2) + "\n");
  file.commit();
}

} // namespace gg::commands
