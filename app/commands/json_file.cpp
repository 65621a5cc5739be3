#include "commands/json_file.h"

#include "core/files.h"

#include <nlohmann/json.hpp>

#include <cstdio>

namespace gg::commands {

void check_json(const std::string& path) {
  if (!path.empty() && path != "-") OutputFile probe(path);
}

void write_json(const std::string& path, nlohmann::json document) {
  document["schema"] = json_schema;
  const std::string text = document.dump(2) + "\n";
  if (path == "-") {
    std::fputs(text.c_str(), stdout);
    return;
  }
  OutputFile file(path);
  file.write(text);
  file.commit();
}

} // namespace gg::commands
