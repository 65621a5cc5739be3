#include "scene/grid.h"

#include <draco/compression/encode.h>
#include <draco/mesh/triangle_soup_mesh_builder.h>
#include <meshoptimizer.h>

#include <cmath>
#include <stdexcept>

namespace gg::test {
namespace {

int bare_accessor(GltfFile& file, int component_type, std::size_t count, const char* type) {
  file.json["accessors"].push_back(
      {{"componentType", component_type}, {"count", count}, {"type", type}});
  return static_cast<int>(file.json["accessors"].size()) - 1;
}

// Appends packed bytes and the accessor that reads them unpacked.
int meshopt_accessor(GltfFile& file, std::vector<unsigned char> packed, std::size_t count,
                     std::size_t stride, const char* mode, const char* filter, int component_type,
                     const char* type) {
  const int view = file.view(packed.data(), packed.size());
  auto& json = file.json["bufferViews"][view];
  json = {{"buffer", file.json["buffers"].size() - 1},
          {"byteLength", count * stride},
          {"extensions",
           {{"EXT_meshopt_compression",
             {{"buffer", 0},
              {"byteOffset", json["byteOffset"]},
              {"byteLength", packed.size()},
              {"byteStride", stride},
              {"count", count},
              {"mode", mode},
              {"filter", filter}}}}}};
  if (std::string(mode) == "ATTRIBUTES") json["byteStride"] = stride;
  const int accessor = bare_accessor(file, component_type, count, type);
  file.json["accessors"][accessor]["bufferView"] = view;
  return accessor;
}

std::vector<unsigned char> packed_vertices(const void* data, std::size_t count,
                                           std::size_t stride) {
  std::vector<unsigned char> packed(meshopt_encodeVertexBufferBound(count, stride));
  packed.resize(meshopt_encodeVertexBuffer(packed.data(), packed.size(), data, count, stride));
  return packed;
}

} // namespace

Grid::Grid(std::uint32_t n) {
  for (std::uint32_t y = 0; y <= n; ++y)
    for (std::uint32_t x = 0; x <= n; ++x) {
      const float u = static_cast<float>(x), v = static_cast<float>(y);
      positions.insert(positions.end(), {u, v, std::sin(u) * std::cos(v)});
      const glm::vec3 normal =
          glm::normalize(glm::vec3(-std::cos(u) * std::cos(v), std::sin(u) * std::sin(v), 1.0f));
      normals.insert(normals.end(), {normal.x, normal.y, normal.z});
    }
  for (std::uint32_t y = 0; y < n; ++y)
    for (std::uint32_t x = 0; x < n; ++x) {
      const std::uint32_t a = y * (n + 1) + x, b = a + n + 1;
      indices.insert(indices.end(), {a, a + 1, b + 1, a, b + 1, b});
    }
}

nlohmann::json plain(GltfFile& file, const Grid& grid) {
  const int positions = file.accessor(grid.positions, "VEC3");
  const int normals = file.accessor(grid.normals, "VEC3");
  const int indices = file.accessor(grid.indices, "SCALAR");
  return {{"attributes", {{"POSITION", positions}, {"NORMAL", normals}}}, {"indices", indices}};
}

namespace {

nlohmann::json draco_encoded(GltfFile& file, const Grid& grid, draco::MeshEncoderMethod method) {
  draco::TriangleSoupMeshBuilder builder;
  const std::size_t faces = grid.indices.size() / 3;
  builder.Start(static_cast<int>(faces));
  const int position =
      builder.AddAttribute(draco::GeometryAttribute::POSITION, 3, draco::DT_FLOAT32);
  const int normal = builder.AddAttribute(draco::GeometryAttribute::NORMAL, 3, draco::DT_FLOAT32);
  for (std::size_t f = 0; f < faces; ++f) {
    const auto* i = grid.indices.data() + 3 * f;
    const draco::FaceIndex face(static_cast<std::uint32_t>(f));
    builder.SetAttributeValuesForFace(position, face, &grid.positions[3 * i[0]],
                                      &grid.positions[3 * i[1]], &grid.positions[3 * i[2]]);
    builder.SetAttributeValuesForFace(normal, face, &grid.normals[3 * i[0]],
                                      &grid.normals[3 * i[1]], &grid.normals[3 * i[2]]);
  }
  const auto mesh = builder.Finalize();
  draco::Encoder encoder;
  encoder.SetEncodingMethod(method);
  draco::EncoderBuffer buffer;
  if (!mesh || !encoder.EncodeMeshToBuffer(*mesh, &buffer).ok())
    throw std::runtime_error("Draco cannot encode the grid");

  const int view = file.view(buffer.data(), buffer.size());
  const int positions = bare_accessor(file, 5126, mesh->num_points(), "VEC3");
  const int normals = bare_accessor(file, 5126, mesh->num_points(), "VEC3");
  const int indices = bare_accessor(file, 5125, grid.indices.size(), "SCALAR");
  file.json["extensionsRequired"].push_back("KHR_draco_mesh_compression");
  return {{"attributes", {{"POSITION", positions}, {"NORMAL", normals}}},
          {"indices", indices},
          {"extensions",
           {{"KHR_draco_mesh_compression",
             {{"bufferView", view},
              {"attributes",
               {{"POSITION", mesh->attribute(position)->unique_id()},
                {"NORMAL", mesh->attribute(normal)->unique_id()}}}}}}}};
}

} // namespace

nlohmann::json with_draco(GltfFile& file, const Grid& grid) {
  return draco_encoded(file, grid, draco::MESH_SEQUENTIAL_ENCODING);
}

nlohmann::json with_edgebreaker(GltfFile& file, const Grid& grid) {
  return draco_encoded(file, grid, draco::MESH_EDGEBREAKER_ENCODING);
}

nlohmann::json with_meshopt(GltfFile& file, const Grid& grid) {
  const std::size_t vertices = grid.positions.size() / 3;
  std::vector<unsigned char> triangles(
      meshopt_encodeIndexBufferBound(grid.indices.size(), vertices));
  triangles.resize(meshopt_encodeIndexBuffer(triangles.data(), triangles.size(),
                                             grid.indices.data(), grid.indices.size()));
  std::vector<float> vectors;
  for (std::size_t i = 0; i < vertices; ++i)
    vectors.insert(vectors.end(),
                   {grid.normals[3 * i], grid.normals[3 * i + 1], grid.normals[3 * i + 2], 0.0f});
  std::vector<std::int8_t> octahedral(4 * vertices);
  meshopt_encodeFilterOct(octahedral.data(), vertices, 4, 8, vectors.data());

  file.json["buffers"].push_back({{"byteLength", 1 << 20}}); // the fallback
  const int positions = meshopt_accessor(file, packed_vertices(grid.positions.data(), vertices, 12),
                                         vertices, 12, "ATTRIBUTES", "NONE", 5126, "VEC3");
  const int normals = meshopt_accessor(file, packed_vertices(octahedral.data(), vertices, 4),
                                       vertices, 4, "ATTRIBUTES", "OCTAHEDRAL", 5120, "VEC3");
  file.json["accessors"][normals]["normalized"] = true;
  const int indices = meshopt_accessor(file, std::move(triangles), grid.indices.size(), 4,
                                       "TRIANGLES", "NONE", 5125, "SCALAR");
  for (const char* extension : {"EXT_meshopt_compression", "KHR_mesh_quantization"})
    file.json["extensionsRequired"].push_back(extension);
  return {{"attributes", {{"POSITION", positions}, {"NORMAL", normals}}}, {"indices", indices}};
}

} // namespace gg::test
