// The tables of one rough interface as half floats, for other people's programs.
#pragma once

#include <filesystem>

namespace gg::kit {

// tables.json, which says sizes, channels, axes and filtering, and a .bin for each: RGBA half floats. Throws Error(output).
void write_tables(const std::filesystem::path& home, const std::filesystem::path& directory);

} // namespace gg::kit
