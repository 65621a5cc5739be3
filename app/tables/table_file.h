// Tables on disk: OpenEXR, half floats, channels by name.
#pragma once

#include "tables/lobe.h"

#include <filesystem>
#include <string>
#include <vector>

namespace gg::tables {

// What a file holds: its name is stem + model + ".exr"; channels in the order of a texel's components (four are kept in
// memory, what is missing is 0).
struct TableLayout {
  std::string stem;
  int width = 0, height = 0;
  std::vector<std::string> channels;
  std::string axes;                    // for who opens the file
  float least = 0.0f, greatest = 4.0f; // nothing beyond these is in a sound table
};

void write_table(const std::filesystem::path& directory, const TableLayout& layout,
                 const Model& model, const std::vector<float>& texels);
// Throws Error(input) if the file is missing, of another size, or holds what it cannot.
std::vector<float> read_table(const std::filesystem::path& directory, const TableLayout& layout,
                              const Model& model);

} // namespace gg::tables
