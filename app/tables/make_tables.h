// All tables, into files.
#pragma once

#include <filesystem>
#include <string>

namespace gg::tables {

// Fits and writes every table whose file name (without its extension) holds a match of the regular expression `only`, with
// progress on a terminal. The same bytes every time. Throws Error(usage) if no name does or `only` is no expression,
// Error(output) if a file cannot be written.
void make_tables(const std::filesystem::path& directory, const std::string& only = {});

} // namespace gg::tables
