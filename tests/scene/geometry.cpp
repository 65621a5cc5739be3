// Normals and tangents: the file's own, or by definition.
#include "core/files.h"
#include "scene/gltf_file.h"
#include "scene/load.h"
#include "scene/normals.h"
#include "scene/tangents.h"
#include "support/scratch.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>

using namespace gg;
using namespace gg::test;

namespace {

nlohmann::json with_normal_map(GltfFile& file) {
  file.json["images"].push_back(
      {{"uri", "data:image/png;base64,"
                   + std::string("iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAYAAAAfFcSJAAAADUlEQVR42mNk+"
                                 "M9QDwADhgGAWjR9awAAAABJRU5ErkJggg==")}});
  file.json["textures"].push_back({{"source", 0}});
  file.json["materials"].push_back({{"normalTexture", {{"index", 0}}}});
  return 0;
}

// A square in the xy plane whose texture coordinates are an affine map of its position.
scene::Scene textured_square(const std::vector<float>& uvs, const nlohmann::json& transform = {}) {
  GltfFile file;
  const int positions = file.accessor<float>({0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0}, "VEC3");
  const int normals = file.accessor<float>({0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1}, "VEC3");
  const int coordinates = file.accessor(uvs, "VEC2");
  const int indices = file.accessor<std::uint8_t>({0, 1, 2, 0, 2, 3}, "SCALAR");
  file.mesh(
      {{"attributes", {{"POSITION", positions}, {"NORMAL", normals}, {"TEXCOORD_0", coordinates}}},
       {"indices", indices},
       {"material", with_normal_map(file)}});
  if (!transform.is_null())
    file.json["materials"][0]["normalTexture"]["extensions"]["KHR_texture_transform"] = transform;
  return scene::load(file.save());
}

glm::vec4 tangent_at(const scene::Scene& scene, std::size_t vertex) {
  const float* t = values(scene, first(scene).tangents).data() + 4 * vertex;
  return {t[0], t[1], t[2], t[3]};
}

TEST(normals, missing_ones_are_flat_and_face_the_front) {
  GltfFile file;
  const int positions = file.accessor<float>({0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1}, "VEC3");
  const int indices = file.accessor<std::uint16_t>({0, 1, 2, 0, 2, 3}, "SCALAR");
  file.mesh({{"attributes", {{"POSITION", positions}}}, {"indices", indices}});
  const auto scene = scene::load(file.save());
  const auto& p = first(scene);
  const auto& list = scene.indices[static_cast<std::size_t>(p.indices)];
  ASSERT_EQ(list.size(), 6u);
  for (std::size_t i = 0; i < 6; ++i)
    EXPECT_EQ(vec3_at(scene, p.normals, list[i]), i < 3 ? glm::vec3(0, 0, 1) : glm::vec3(1, 0, 0));
}

TEST(normals, triangles_without_area_still_have_one) {
  const std::vector<float> positions = {0, 0, 0, 1, 1, 1, 2, 2, 2};
  const std::vector<std::uint32_t> indices = {0, 1, 2};
  EXPECT_EQ(scene::flat_normals(positions, indices),
            (std::vector<float>{0, 0, 1, 0, 0, 1, 0, 0, 1}));
}

TEST(normals, millimetre_models_have_unit_normals_too) {
  const std::vector<float> positions = {0, 0, 0, 1e-20f, 0, 0, 0, 1e-20f, 0};
  const std::vector<std::uint32_t> indices = {0, 1, 2};
  EXPECT_EQ(scene::flat_normals(positions, indices),
            (std::vector<float>{0, 0, 1, 0, 0, 1, 0, 0, 1}));
}

TEST(normals, those_of_zero_length_are_mended_from_their_faces) {
  GltfFile file;
  file.triangle();
  file.primitive()["attributes"]["NORMAL"] =
      file.accessor<float>({0, 0, 0, 1, 0, 0, 0, 0, 0}, "VEC3");
  const auto scene = scene::load(file.save());
  EXPECT_EQ(values(scene, first(scene).normals), (std::vector<float>{0, 0, 1, 1, 0, 0, 0, 0, 1}));
}

TEST(tangents, point_along_u_with_the_bitangent_up_the_image) {
  // glTF's v runs down the image: here the image stands upright on the square.
  const auto scene = textured_square({0, 1, 1, 1, 1, 0, 0, 0});
  for (std::size_t i = 0; i < 4; ++i)
    EXPECT_EQ(tangent_at(scene, i), glm::vec4(1, 0, 0, 1));
}

TEST(tangents, of_a_mirrored_texture_have_the_other_sign) {
  const auto scene = textured_square({1, 1, 0, 1, 0, 0, 1, 0});
  for (std::size_t i = 0; i < 4; ++i)
    EXPECT_EQ(tangent_at(scene, i), glm::vec4(-1, 0, 0, -1));
}

TEST(tangents, follow_the_texture_transform) {
  // Turned by 90°: uv' = (v, -u), so u' grows where v does, which is down.
  const auto scene =
      textured_square({0, 1, 1, 1, 1, 0, 0, 0}, {{"rotation", std::numbers::pi_v<float> / 2}});
  for (std::size_t i = 0; i < 4; ++i)
    EXPECT_LT(glm::length(tangent_at(scene, i) - glm::vec4(0, -1, 0, 1)), rounding);
}

TEST(tangents, of_coordinates_without_extent_are_perpendicular_to_the_normal) {
  const auto scene = textured_square({0, 0, 0, 0, 0, 0, 0, 0});
  for (std::size_t i = 0; i < 4; ++i) {
    const glm::vec4 t = tangent_at(scene, i);
    EXPECT_NEAR(glm::length(glm::vec3(t)), 1.0f, rounding);
    EXPECT_EQ(t.z, 0.0f);
  }
}

TEST(tangents, of_zero_length_are_generated) {
  GltfFile file;
  const int positions = file.accessor<float>({0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0}, "VEC3");
  const int normals = file.accessor<float>({0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1}, "VEC3");
  const int coordinates = file.accessor<float>({0, 1, 1, 1, 1, 0, 0, 0}, "VEC2");
  const int tangents = file.accessor(std::vector<float>(16, 0.0f), "VEC4");
  file.mesh({{"attributes",
              {{"POSITION", positions},
               {"NORMAL", normals},
               {"TANGENT", tangents},
               {"TEXCOORD_0", coordinates}}},
             {"indices", file.accessor<std::uint8_t>({0, 1, 2, 0, 2, 3}, "SCALAR")},
             {"material", with_normal_map(file)}});
  testing::internal::CaptureStderr();
  const auto scene = scene::load(file.save("zero-tangents.glb"));
  EXPECT_NE(testing::internal::GetCapturedStderr().find("tangents of zero length"),
            std::string::npos);
  for (std::size_t i = 0; i < 4; ++i)
    EXPECT_EQ(tangent_at(scene, i), glm::vec4(1, 0, 0, 1));
}

TEST(texture_coordinates, that_a_material_needs_and_the_mesh_lacks_are_named) {
  GltfFile file;
  file.triangle();
  file.primitive()["material"] = with_normal_map(file);
  file.json["materials"][0]["normalTexture"]["texCoord"] = 3;
  testing::internal::CaptureStderr();
  scene::load(file.save("no-coordinates.glb"));
  const std::string said = testing::internal::GetCapturedStderr();
  EXPECT_NE(said.find("TEXCOORD_3"), std::string::npos) << said;
}

TEST(tangents, are_made_only_where_a_material_needs_them) {
  GltfFile file;
  file.triangle();
  file.primitive()["attributes"]["TEXCOORD_0"] = file.accessor<float>({0, 0, 1, 0, 0, 1}, "VEC2");
  EXPECT_EQ(first(scene::load(file.save())).tangents, scene::none);
}

// Two squares side by side with a mirrored texture on the second: the vertices of the seam need two
// tangents each.
TEST(tangents, vertices_split_where_the_texture_is_mirrored) {
  GltfFile file;
  const int positions =
      file.accessor<float>({0, 0, 0, 1, 0, 0, 2, 0, 0, 0, 1, 0, 1, 1, 0, 2, 1, 0}, "VEC3");
  const int normals =
      file.accessor<float>({0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1}, "VEC3");
  const int uvs = file.accessor<float>({0, 1, 1, 1, 0, 1, 0, 0, 1, 0, 0, 0}, "VEC2");
  const int indices = file.accessor<std::uint8_t>({0, 1, 4, 0, 4, 3, 1, 2, 5, 1, 5, 4}, "SCALAR");
  file.mesh({{"attributes", {{"POSITION", positions}, {"NORMAL", normals}, {"TEXCOORD_0", uvs}}},
             {"indices", indices},
             {"material", with_normal_map(file)}});
  const auto scene = scene::load(file.save());
  const auto& p = first(scene);
  EXPECT_EQ(values(scene, p.positions).size(), 3u * 8u);
  const auto& list = scene.indices[static_cast<std::size_t>(p.indices)];
  for (std::size_t i = 0; i < list.size(); ++i)
    EXPECT_EQ(tangent_at(scene, list[i]), i < 6 ? glm::vec4(1, 0, 0, 1) : glm::vec4(-1, 0, 0, -1));
  EXPECT_EQ(corners(scene, p)[8], glm::vec3(2, 1, 0)); // positions went along
}

// A vertex of a pyramid: three faces count by their angles, whatever their areas.
TEST(tangents, weigh_faces_by_their_angle) {
  const std::vector<float> positions = {0, 0, 0, 1, 0, 0, 0, 1, 0, -5, 0, 0};
  const std::vector<float> normals = {0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1};
  const std::vector<float> uvs = {0, 0, 1, 0, 0, -1, -5, -2}; // the second face is sheared
  const std::vector<std::uint32_t> indices = {0, 1, 2, 0, 2, 3};
  const auto t = scene::corner_tangents(positions, normals, uvs, indices);
  EXPECT_LT(glm::length(t[1] - glm::vec4(1, 0, 0, 1)), rounding);
  const glm::vec3 second = glm::vec3(t[5]);                           // alone at vertex 3
  const glm::vec3 mean = glm::normalize(glm::vec3(1, 0, 0) + second); // both angles are 90°
  EXPECT_LT(glm::length(glm::vec3(t[0]) - mean), rounding);
  EXPECT_EQ(t[0], t[3]);
}

// Angles between the tangents of two primitives, corner by corner.
struct Agreement {
  std::size_t corners = 0, other_sign = 0;
  double mean = 0.0, largest = 0.0; // radians
};

Agreement compare(const scene::Scene& a, const scene::Primitive& pa, const scene::Scene& b,
                  const scene::Primitive& pb) {
  const auto &ia = a.indices[static_cast<std::size_t>(pa.indices)],
             &ib = b.indices[static_cast<std::size_t>(pb.indices)];
  Agreement result;
  result.corners = std::min(ia.size(), ib.size());
  for (std::size_t i = 0; i < result.corners; ++i) {
    const float* x = values(a, pa.tangents).data() + 4 * ia[i];
    const float* y = values(b, pb.tangents).data() + 4 * ib[i];
    const glm::dvec3 tx(x[0], x[1], x[2]), ty(y[0], y[1], y[2]);
    const double angle = std::atan2(glm::length(glm::cross(tx, ty)), glm::dot(tx, ty));
    result.mean += angle / static_cast<double>(result.corners);
    result.largest = std::max(result.largest, angle);
    result.other_sign += x[3] != y[3];
  }
  return result;
}

// The check that the definition is the one that the world uses. The spheres of
// AnisotropyStrengthTest carry tangents that glTF-Transform made with MikkTSpace itself; the same
// file without them must come out the same, but for rounding.
TEST(tangents, are_those_of_mikktspace_itself) {
  const auto bytes = read_file(asset("scenes/AnisotropyStrengthTest.glb"));
  const auto* data = reinterpret_cast<const char*>(bytes.data());
  std::uint32_t length = 0;
  std::memcpy(&length, data + 12, 4);
  auto json = nlohmann::json::parse(std::string_view(data + 20, length));
  for (auto& mesh : json["meshes"])
    mesh["primitives"][0]["attributes"].erase("TANGENT");
  const std::vector<std::byte> payload(bytes.begin() + 28 + length, bytes.end());
  const auto own = scene::load(asset("scenes/AnisotropyStrengthTest.glb"));
  const auto made = scene::load(scratch_file("made.glb", glb(json.dump(), payload)));
  ASSERT_EQ(own.meshes.size(), made.meshes.size());

  std::size_t compared = 0;
  for (std::size_t m = 0; m < own.meshes.size(); ++m) {
    const auto &po = own.meshes[m].primitives[0], &pm = made.meshes[m].primitives[0];
    if (po.tangents == scene::none) continue;
    const Agreement a = compare(own, po, made, pm);
    compared += a.corners;
    EXPECT_EQ(a.other_sign, 0u);
    EXPECT_LT(a.largest, rounding);
  }
  EXPECT_GT(compared, 40u * 5952u); // the spheres that are anisotropic
}

// Suzanne, whose texture is unwrapped with seams and mirrored halves. The sums are those of the
// reference implementation (mikktspace.c, run once on the positions, normals and coordinates of
// this file), w negated because it takes v to run upwards.
TEST(tangents, of_suzanne_are_those_of_the_reference_implementation) {
  const auto scene = scene::load(asset("scenes/Suzanne/Suzanne.gltf"));
  const auto& p = first(scene);
  const auto& indices = scene.indices[static_cast<std::size_t>(p.indices)];
  const auto tangents = scene::corner_tangents(values(scene, p.positions), values(scene, p.normals),
                                               values(scene, p.uvs[0]), indices);
  glm::dvec3 sum(0.0);
  double signs = 0.0;
  for (std::size_t i = 0; i < tangents.size(); ++i) {
    sum += static_cast<double>(i % 101) * glm::dvec3(tangents[i]);
    signs += tangents[i].w;
  }
  const glm::dvec3 reference(68315.196929, -87381.753515, -77054.188466);
  // 11,808 roundings of up to 2e-7 with weights of 50 on average, adding up as errors do: 1e-3.
  const double statistics = std::sqrt(11808.0) * 50 * 2e-7;
  EXPECT_LT(glm::length(sum - reference), statistics);
  EXPECT_EQ(signs, -11808.0);
}

// Suzanne.gltf's own tangents are not MikkTSpace's: its exporter wrote dP/du of each triangle, the
// same at all three corners, not perpendicular to the normals, and always w = 1. What can be
// compared is that direction, which is ours for a mesh with flat normals; the file has it to six
// digits.
TEST(tangents, of_suzanne_point_along_those_in_the_file) {
  const std::filesystem::path directory = scratch_directory();
  std::filesystem::copy(asset("scenes/Suzanne"), directory,
                        std::filesystem::copy_options::recursive
                            | std::filesystem::copy_options::overwrite_existing);
  auto json = nlohmann::json::parse(read_text(directory / "Suzanne.gltf"));
  json["materials"][0]["normalTexture"] = {{"index", 0}}; // so that tangents are wanted
  scratch_file("own.gltf", json.dump());
  auto& attributes = json["meshes"][0]["primitives"][0]["attributes"];
  attributes.erase("TANGENT");
  attributes.erase("NORMAL");
  scratch_file("made.gltf", json.dump());
  const auto own = scene::load(directory / "own.gltf"), made = scene::load(directory / "made.gltf");
  const Agreement a = compare(own, first(own), made, first(made));
  EXPECT_EQ(a.corners, 11808u);
  EXPECT_LT(a.mean, 1e-3);
  EXPECT_EQ(a.other_sign, a.corners); // ours says that the image's up is -v
}

} // namespace
