// What --json writes.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include <string>

namespace gg::commands {

// The version of the keys that app/README.md lists: raised when one changes its name or meaning.
inline constexpr int json_schema = 2;

// Throws Error(output) if the file cannot be written: before the work whose results go there.
void check_json(const std::string& path);
// The document with `schema` added, to the file, or to standard output for "-". Throws Error(output).
void write_json(const std::string& path, nlohmann::json document);

} // namespace gg::commands
