// A mesh to compress.
#pragma once

#include "scene/gltf_file.h"

namespace gg::test {

// n x n squares with a bulge.
struct Grid {
  std::vector<float> positions, normals;
  std::vector<std::uint32_t> indices;
  explicit Grid(std::uint32_t n);
};

// Each appends what the grid needs to a file and returns the primitive that reads it.
nlohmann::json plain(GltfFile& file, const Grid& grid);
// KHR_draco_mesh_compression, sequential: the order of the triangles is kept.
nlohmann::json with_draco(GltfFile& file, const Grid& grid);
// The same by the edgebreaker, which most exporters use: it finds an order of its own.
nlohmann::json with_edgebreaker(GltfFile& file, const Grid& grid);
// EXT_meshopt_compression as gltfpack writes it: positions through the vertex codec, normals
// through the octahedral filter as well, triangles through the index codec, a fallback buffer
// without data.
nlohmann::json with_meshopt(GltfFile& file, const Grid& grid);

} // namespace gg::test
