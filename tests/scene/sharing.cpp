// What a scene costs: shared accessors are held once, whole models load quickly and as described.
#include "scene/gltf_file.h"
#include "scene/load.h"

#include <gtest/gtest.h>

#include <chrono>

using namespace gg;
using namespace gg::test;

namespace {

std::size_t bytes_of(const scene::Scene& scene) {
  std::size_t bytes = 0;
  for (const auto& stream : scene.streams)
    bytes += stream.values.size() * sizeof(float);
  for (const auto& list : scene.indices)
    bytes += list.size() * sizeof(std::uint32_t);
  return bytes;
}

// 102 meshes read 78 accessors. Unshared, a million triangles of 24-byte vertices would be tens of
// megabytes; the file's own binary part is 241,588 bytes, of which 16-bit indices double.
TEST(sharing, a_million_triangles_stay_three_hundred_kilobytes) {
  const auto start = std::chrono::steady_clock::now();
  const auto scene = scene::load(asset("scenes/MetalRoughSpheresNoTextures.glb"));
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  EXPECT_EQ(scene.triangle_count(), 1040409u);
  EXPECT_EQ(scene.instances.size(), 102u);
  EXPECT_EQ(scene.materials.size(), 99u); // 98 and the default
  EXPECT_EQ(bytes_of(scene), 314820u);
  EXPECT_LT(seconds.count(), 5.0); // measured: 0.01 s; slow machines and sanitizers included
}

TEST(sharing, generated_streams_are_shared_too) {
  GltfFile file;
  file.triangle();
  for (int i = 0; i < 9; ++i)
    file.mesh(file.primitive());
  const auto scene = scene::load(file.save());
  EXPECT_EQ(scene.meshes.size(), 10u);
  EXPECT_EQ(bytes_of(scene), 3 * (12 + 12 + 4u)); // one triangle: positions, normals, indices
}

TEST(sharing, a_mesh_placed_twice_is_held_once) {
  GltfFile file;
  file.triangle();
  file.json["nodes"].push_back({{"mesh", 0}});
  file.json["scenes"][0]["nodes"] = {0, 1};
  const auto scene = scene::load(file.save());
  EXPECT_EQ(scene.meshes.size(), 1u);
  EXPECT_EQ(scene.triangle_count(), 2u);
}

TEST(models, are_as_described) {
  const struct {
    const char* name;
    std::size_t triangles, images;
  } models[] = {{"TransmissionRoughnessTest.glb", 77792, 5},
                {"TransmissionTest.glb", 128775, 9},
                {"GlassVaseFlowers.glb", 14036, 4},
                {"AnisotropyStrengthTest.glb", 97240, 1},
                {"shaderball.glb", 88264, 0},
                {"Suzanne/Suzanne.gltf", 3936, 2}};
  for (const auto& model : models) {
    const auto scene = scene::load(asset(std::string("scenes/") + model.name));
    EXPECT_EQ(scene.triangle_count(), model.triangles) << model.name;
    const auto decoded = std::count_if(scene.images.begin(), scene.images.end(),
                                       [](const auto& image) { return image != nullptr; });
    EXPECT_EQ(static_cast<std::size_t>(decoded), model.images) << model.name;
    EXPECT_FALSE(scene.bounds.empty());
  }
}

} // namespace
