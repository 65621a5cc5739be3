// Compressed geometry comes out as it went in.
#include "scene/gltf_file.h"
#include "scene/load.h"

#include <draco/compression/encode.h>
#include <draco/mesh/triangle_soup_mesh_builder.h>
#include <gtest/gtest.h>
#include <meshoptimizer.h>

#include <cmath>

using namespace gg;
using namespace gg::test;

namespace {

// A grid of n x n squares with a bulge.
struct Grid {
  std::vector<float> positions, normals;
  std::vector<std::uint32_t> indices;
  explicit Grid(std::uint32_t n) {
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
};

GltfFile plain(const Grid& grid) {
  GltfFile file;
  const int positions = file.accessor(grid.positions, "VEC3");
  const int normals = file.accessor(grid.normals, "VEC3");
  const int indices = file.accessor(grid.indices, "SCALAR");
  file.mesh({{"attributes", {{"POSITION", positions}, {"NORMAL", normals}}}, {"indices", indices}});
  return file;
}

nlohmann::json bare_accessor(int component_type, std::size_t count, const char* type) {
  return {{"componentType", component_type}, {"count", count}, {"type", type}};
}

TEST(draco, gives_back_the_mesh) {
  const Grid grid(12);
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
  ASSERT_TRUE(mesh);
  draco::Encoder encoder;
  encoder.SetEncodingMethod(draco::MESH_SEQUENTIAL_ENCODING); // keeps the order of the triangles
  draco::EncoderBuffer buffer;
  ASSERT_TRUE(encoder.EncodeMeshToBuffer(*mesh, &buffer).ok());

  GltfFile file;
  const int view = file.view(buffer.data(), buffer.size());
  file.json["accessors"] = {bare_accessor(5126, mesh->num_points(), "VEC3"),
                            bare_accessor(5126, mesh->num_points(), "VEC3"),
                            bare_accessor(5125, grid.indices.size(), "SCALAR")};
  file.mesh({{"attributes", {{"POSITION", 0}, {"NORMAL", 1}}},
             {"indices", 2},
             {"extensions",
              {{"KHR_draco_mesh_compression",
                {{"bufferView", view},
                 {"attributes",
                  {{"POSITION", mesh->attribute(position)->unique_id()},
                   {"NORMAL", mesh->attribute(normal)->unique_id()}}}}}}}});
  file.json["extensionsRequired"] = {"KHR_draco_mesh_compression"};
  const auto scene = scene::load(file.save()), original = scene::load(plain(grid).save());
  EXPECT_EQ(corners(scene, first(scene)), corners(original, first(original)));
}

// Attributes through the vertex codec, triangles through the index codec, normals through the
// octahedral filter: as gltfpack writes them.
TEST(meshopt, gives_back_the_mesh) {
  const Grid grid(12);
  const std::size_t vertices = grid.positions.size() / 3;
  const auto encode_vertices = [&](const void* data, std::size_t stride) {
    std::vector<unsigned char> packed(meshopt_encodeVertexBufferBound(vertices, stride));
    packed.resize(meshopt_encodeVertexBuffer(packed.data(), packed.size(), data, vertices, stride));
    return packed;
  };
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

  GltfFile file;
  file.json["buffers"].push_back({{"byteLength", 1 << 20}}); // the fallback, which has no data
  const auto add = [&](const std::vector<unsigned char>& packed, std::size_t count,
                       std::size_t stride, const char* mode, const char* filter) {
    const int view = file.view(packed.data(), packed.size());
    auto& json = file.json["bufferViews"][view];
    json = {{"buffer", 1},
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
    return view;
  };
  const int positions =
      add(encode_vertices(grid.positions.data(), 12), vertices, 12, "ATTRIBUTES", "NONE");
  const int normals =
      add(encode_vertices(octahedral.data(), 4), vertices, 4, "ATTRIBUTES", "OCTAHEDRAL");
  const int indices = add(triangles, grid.indices.size(), 4, "TRIANGLES", "NONE");
  file.json["accessors"] = {bare_accessor(5126, vertices, "VEC3"),
                            bare_accessor(5120, vertices, "VEC3"),
                            bare_accessor(5125, grid.indices.size(), "SCALAR")};
  file.json["accessors"][0]["bufferView"] = positions;
  file.json["accessors"][1]["bufferView"] = normals;
  file.json["accessors"][1]["normalized"] = true;
  file.json["accessors"][2]["bufferView"] = indices;
  file.mesh({{"attributes", {{"POSITION", 0}, {"NORMAL", 1}}}, {"indices", 2}});
  file.json["extensionsRequired"] = {"EXT_meshopt_compression", "KHR_mesh_quantization"};

  const auto scene = scene::load(file.save()), original = scene::load(plain(grid).save());
  const auto &p = first(scene), &o = first(original);
  EXPECT_EQ(values(scene, p.positions), values(original, o.positions));
  // The index codec may turn a triangle's corners, not its winding.
  const auto a = corners(scene, p), b = corners(original, o);
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); i += 3)
    EXPECT_TRUE((a[i] == b[i] && a[i + 1] == b[i + 1]) || (a[i] == b[i + 1] && a[i + 1] == b[i + 2])
                || (a[i] == b[i + 2] && a[i + 1] == b[i]));
  constexpr float quantisation = 0.02f; // two steps of 1/127 in the octahedron's plane
  for (std::size_t i = 0; i < vertices; ++i)
    EXPECT_LT(glm::length(vec3_at(scene, p.normals, i) - vec3_at(original, o.normals, i)),
              quantisation);
}

} // namespace
