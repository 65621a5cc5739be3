// Damaged scenes: each kind of fault by name, with the place that the message must give. Under the
// sanitizers this is the test that the loader stays within its memory.
#include "core/error.h"
#include "scene/framing.h"
#include "scene/grid.h"
#include "scene/load.h"
#include "support/errors.h"
#include "support/scratch.h"

#include <gtest/gtest.h>

#include <functional>

using namespace gg;
using namespace gg::test;
using nlohmann::json;

namespace {

// Two nodes, a textured mesh with indices, a skin, a morph target, a camera and a light.
GltfFile sound() {
  GltfFile file;
  const Grid grid(2);
  auto primitive = plain(file, grid);
  const std::size_t vertices = grid.positions.size() / 3;
  primitive["material"] = 0;
  primitive["attributes"]["TEXCOORD_0"] =
      file.accessor(std::vector<float>(2 * vertices, 0.5f), "VEC2");
  primitive["attributes"]["JOINTS_0"] =
      file.accessor(std::vector<std::uint8_t>(4 * vertices, 0), "VEC4");
  primitive["attributes"]["WEIGHTS_0"] =
      file.accessor(std::vector<float>(4 * vertices, 0.25f), "VEC4");
  primitive["targets"] = {{{"POSITION", file.accessor(grid.normals, "VEC3")}}};
  file.mesh(primitive);
  auto& j = file.json;
  j["meshes"][0]["weights"] = {0.5};
  j["nodes"].push_back({{"camera", 0}, {"children", {2}}});
  j["nodes"].push_back({{"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}});
  j["scenes"][0]["nodes"] = {0, 1};
  j["nodes"][0]["skin"] = 0;
  std::vector<float> identity(16, 0.0f);
  for (std::size_t i = 0; i < 16; i += 5)
    identity[i] = 1.0f;
  j["skins"] = {{{"joints", {1}}, {"inverseBindMatrices", file.accessor(identity, "MAT4")}}};
  j["cameras"] = {{{"type", "perspective"}, {"perspective", {{"yfov", 1}, {"znear", 0.1}}}}};
  j["extensions"]["KHR_lights_punctual"]["lights"] = {{{"type", "point"}}};
  j["materials"] = {{{"normalTexture", {{"index", 0}}}}};
  j["textures"] = {{{"source", 0}, {"sampler", 0}}};
  j["samplers"] = {json::object()};
  j["images"] = {{{"uri", "data:image/png;base64,"
                          "iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAIAAACQd1PeAAAADElEQVR42mP4z8AAAAMBAQD3"
                          "A0FDAAAAAElFTkSuQmCC"}}};
  return file;
}

struct Fault {
  const char* name;
  std::function<void(GltfFile&)> make;
  std::vector<std::string> message; // parts that it must have
  ExitCode code = ExitCode::input;
};

void PrintTo(const Fault& fault, std::ostream* out) {
  *out << fault.name;
}

class BadScene : public ::testing::TestWithParam<Fault> {};

TEST_P(BadScene, is_refused_with_its_place) {
  GltfFile file = sound();
  ASSERT_NO_THROW(scene::load(file.save("sound.glb")));
  GetParam().make(file);
  auto parts = GetParam().message;
  parts.push_back("scene.glb");
  EXPECT_TRUE(fails_with(GetParam().code, parts, [&] { scene::load(file.save()); }));
}

void set_float(GltfFile& file, int accessor, std::size_t index, float value) {
  const auto view = file.json["accessors"][accessor]["bufferView"].get<std::size_t>();
  const auto offset = file.json["bufferViews"][view]["byteOffset"].get<std::size_t>();
  std::memcpy(file.bytes.data() + offset + 4 * index, &value, 4);
}

constexpr std::uint64_t four_giga = std::uint64_t{4} << 30;

const Fault faults[] = {
    {"no_asset", [](GltfFile& f) { f.json.erase("asset"); }, {"asset"}},
    {"no_version", [](GltfFile& f) { f.json["asset"].erase("version"); }, {"asset.version"}},
    {"version_one",
     [](GltfFile& f) { f.json["asset"]["version"] = "1.0"; },
     {"asset.version", "1.0"},
     ExitCode::unsupported},
    {"newer_least_version",
     [](GltfFile& f) { f.json["asset"]["minVersion"] = "2.1"; },
     {"asset.minVersion", "2.1"},
     ExitCode::unsupported},
    {"unknown_required_extension",
     [](GltfFile& f) { f.json["extensionsRequired"] = {"KHR_unheard_of"}; },
     {"KHR_unheard_of"},
     ExitCode::unsupported},
    {"required_ktx2",
     [](GltfFile& f) { f.json["extensionsRequired"] = {"KHR_texture_basisu"}; },
     {"KHR_texture_basisu", "PNG"},
     ExitCode::unsupported},
    {"ktx2_image",
     [](GltfFile& f) {
       f.json["images"][0]["uri"] =
           "data:image/ktx2;base64," + base64("\xABKTX 20\xBB\r\n\x1A\n", 12);
     },
     {"images[0]", "KTX2", "truncated"}},
    {"meshes_is_a_number", [](GltfFile& f) { f.json["meshes"] = 5; }, {"meshes", "array"}},
    {"mesh_is_a_string", [](GltfFile& f) { f.json["meshes"][0] = "x"; }, {"meshes[0]", "object"}},
    {"no_primitives",
     [](GltfFile& f) { f.json["meshes"][0].erase("primitives"); },
     {"meshes[0].primitives", "missing"}},
    {"fraction_as_index", [](GltfFile& f) { f.json["nodes"][0]["mesh"] = 0.5; }, {"nodes[0].mesh"}},
    {"negative_index", [](GltfFile& f) { f.json["nodes"][0]["mesh"] = -1; }, {"nodes[0].mesh"}},
    {"mesh_out_of_range",
     [](GltfFile& f) { f.json["nodes"][0]["mesh"] = 7; },
     {"nodes[0].mesh", "7", "1"}},
    {"index_beyond_64_bits",
     [](GltfFile& f) { f.json["nodes"][0]["mesh"] = std::uint64_t{18446744073709551615u}; },
     {"nodes[0].mesh"}},
    {"camera_out_of_range",
     [](GltfFile& f) { f.json["nodes"][1]["camera"] = 1; },
     {"nodes[1].camera"}},
    {"skin_out_of_range", [](GltfFile& f) { f.json["nodes"][0]["skin"] = 1; }, {"nodes[0].skin"}},
    {"light_out_of_range",
     [](GltfFile& f) { f.json["nodes"][2]["extensions"]["KHR_lights_punctual"]["light"] = 1; },
     {"nodes[2].extensions.KHR_lights_punctual.light"}},
    {"scene_out_of_range", [](GltfFile& f) { f.json["scene"] = 3; }, {"scene"}},
    {"material_out_of_range",
     [](GltfFile& f) { f.primitive()["material"] = 9; },
     {"meshes[0].primitives[0].material"}},
    {"texture_out_of_range",
     [](GltfFile& f) { f.json["materials"][0]["normalTexture"]["index"] = 9; },
     {"materials[0].normalTexture.index"}},
    {"attribute_out_of_range",
     [](GltfFile& f) { f.primitive()["attributes"]["NORMAL"] = 99; },
     {"meshes[0].primitives[0].attributes.NORMAL"}},
    {"node_is_its_own_child",
     [](GltfFile& f) { f.json["nodes"][1]["children"] = {1}; },
     {"nodes[1]"}},
    {"nodes_in_a_ring",
     [](GltfFile& f) {
       f.json["nodes"][2]["children"] = {3};
       f.json["nodes"].push_back({{"children", {2}}});
       f.json["nodes"][1].erase("children");
     },
     {"nodes[2].children", "ancestor"}},
    {"node_with_two_parents",
     [](GltfFile& f) { f.json["nodes"][0]["children"] = {2}; },
     {"children", "node 2"}},
    {"scene_lists_a_child",
     [](GltfFile& f) {
       f.json["scenes"][0]["nodes"] = {0, 1, 2};
     },
     {"scenes", "root"}},
    {"matrix_of_fifteen",
     [](GltfFile& f) { f.json["nodes"][1]["matrix"] = std::vector<int>(15, 1); },
     {"nodes[1].matrix", "15"}},
    {"matrix_not_affine",
     [](GltfFile& f) { f.json["nodes"][1]["matrix"] = std::vector<int>(16, 1); },
     {"nodes[1].matrix"}},
    {"rotation_of_length_zero",
     [](GltfFile& f) {
       f.json["nodes"][1]["rotation"] = {0, 0, 0, 0};
     },
     {"nodes[1].rotation"}},
    {"scale_too_large_for_a_float",
     [](GltfFile& f) {
       f.json["nodes"][1]["scale"] = {1e60, 1, 1};
     },
     {"nodes[1].scale"}},
    {"scales_that_multiply_to_infinity",
     [](GltfFile& f) {
       f.json["nodes"][1]["scale"] = {1e30, 1, 1};
       f.json["nodes"][2]["scale"] = {1e30, 1, 1};
     },
     {"nodes[2]", "finite"}},
    {"scene_too_large",
     [](GltfFile& f) {
       f.json["nodes"][0].erase("skin");
       f.json["nodes"][0]["scale"] = {1e25, 1e25, 1e25};
     },
     {"spans"}},
    {"position_too_large",
     [](GltfFile& f) { set_float(f, 0, 4, 1e30f); },
     {"meshes[0].primitives[0].attributes.POSITION"}},
    {"position_not_a_number", [](GltfFile& f) { set_float(f, 0, 4, NAN); }, {"accessors[0]"}},
    {"normal_infinite", [](GltfFile& f) { set_float(f, 1, 0, INFINITY); }, {"accessors[1]"}},
    {"inverse_bind_matrix_not_a_number",
     [](GltfFile& f) { set_float(f, f.json["skins"][0]["inverseBindMatrices"], 3, NAN); },
     {"accessors["}},
    {"vertex_out_of_range",
     [](GltfFile& f) {
       const auto view = f.json["accessors"][2]["bufferView"].get<std::size_t>();
       f.bytes[f.json["bufferViews"][view]["byteOffset"].get<std::size_t>()] = std::byte{200};
     },
     {"meshes[0].primitives[0].indices", "200"}},
    {"floats_as_indices",
     [](GltfFile& f) { f.json["accessors"][2]["componentType"] = 5126; },
     {"accessors[2].componentType"}},
    {"vectors_as_indices",
     [](GltfFile& f) {
       f.json["accessors"][2]["type"] = "VEC2";
       f.json["accessors"][2]["count"] = 12;
     },
     {"accessors[2].type"}},
    {"normals_of_two_components",
     [](GltfFile& f) { f.json["accessors"][1]["type"] = "VEC2"; },
     {"attributes.NORMAL", "2"}},
    {"fewer_normals_than_positions",
     [](GltfFile& f) { f.json["accessors"][1]["count"] = 8; },
     {"9 positions", "8 normals"}},
    {"unknown_component_type",
     [](GltfFile& f) { f.json["accessors"][0]["componentType"] = 5124; },
     {"accessors[0].componentType"}},
    {"unknown_type",
     [](GltfFile& f) { f.json["accessors"][0]["type"] = "VEC5"; },
     {"accessors[0].type", "VEC5"}},
    {"count_of_zero",
     [](GltfFile& f) { f.json["accessors"][0]["count"] = 0; },
     {"accessors[0].count"}},
    {"four_gigabytes_of_accessor",
     [](GltfFile& f) { f.json["accessors"][0]["count"] = four_giga / 12; },
     {"accessors[0]", "bytes"}},
    {"four_gigabytes_without_data",
     [](GltfFile& f) {
       f.json["accessors"][0]["count"] = four_giga / 12;
       f.json["accessors"][0].erase("bufferView");
     },
     {"accessors[0].count", "MiB"}},
    {"count_that_overflows",
     [](GltfFile& f) { f.json["accessors"][0]["count"] = std::uint64_t{1} << 62; },
     {"accessors[0].count"}},
    {"byte_offset_that_overflows",
     [](GltfFile& f) { f.json["accessors"][0]["byteOffset"] = 9007199254740000; },
     {"accessors[0]"}},
    {"stride_less_than_an_element",
     [](GltfFile& f) { f.json["bufferViews"][0]["byteStride"] = 8; },
     {"bufferViews[0].byteStride"}},
    {"view_beyond_its_buffer",
     [](GltfFile& f) { f.json["bufferViews"][0]["byteLength"] = 1 << 20; },
     {"bufferViews[0]"}},
    {"view_that_overflows",
     [](GltfFile& f) { f.json["bufferViews"][0]["byteOffset"] = 9007199254740991; },
     {"bufferViews[0]"}},
    {"buffer_longer_than_its_data",
     [](GltfFile& f) { f.json["buffers"][0]["byteLength"] = 1 << 20; },
     {"buffers[0].byteLength"}},
    {"buffer_without_data",
     [](GltfFile& f) {
       f.json["buffers"].push_back({{"byteLength", 100}});
       f.json["bufferViews"][0]["buffer"] = 1;
     },
     {"buffers[1]"}},
    {"buffer_file_missing",
     [](GltfFile& f) { f.json["buffers"][0]["uri"] = "nowhere.bin"; },
     {"buffers[0].uri", "nowhere.bin"}},
    {"buffer_outside_the_directory",
     [](GltfFile& f) { f.json["buffers"][0]["uri"] = "a/../../secret.bin"; },
     {"buffers[0].uri", "outside"}},
    {"buffer_outside_the_directory_encoded",
     [](GltfFile& f) { f.json["buffers"][0]["uri"] = "%2e%2e/secret.bin"; },
     {"buffers[0].uri", "outside"}},
    {"buffer_at_an_absolute_path",
     [](GltfFile& f) { f.json["buffers"][0]["uri"] = "/etc/passwd"; },
     {"buffers[0].uri", "outside"}},
    {"buffer_from_the_network",
     [](GltfFile& f) { f.json["buffers"][0]["uri"] = "https://example.org/a.bin"; },
     {"buffers[0].uri", "downloaded"}},
    {"buffer_of_broken_base64",
     [](GltfFile& f) { f.json["buffers"][0]["uri"] = "data:;base64,AA*A"; },
     {"buffers[0].uri", "base64"}},
    {"buffer_of_another_encoding",
     [](GltfFile& f) { f.json["buffers"][0]["uri"] = "data:,hello"; },
     {"buffers[0].uri", "base64"}},
    {"image_of_noise",
     [](GltfFile& f) { f.json["images"][0]["uri"] = "data:image/png;base64,AAAAAAAA"; },
     {"images[0]"}},
    {"image_file_missing",
     [](GltfFile& f) { f.json["images"][0]["uri"] = "nowhere.png"; },
     {"images[0].uri", "nowhere.png"}},
    {"image_without_source",
     [](GltfFile& f) { f.json["images"][0] = json::object(); },
     {"images[0]"}},
    {"texture_without_image",
     [](GltfFile& f) { f.json["textures"][0].erase("source"); },
     {"textures[0]"}},
    {"sampler_of_unknown_wrap",
     [](GltfFile& f) { f.json["samplers"][0]["wrapS"] = 20000; },
     {"samplers[0].wrapS"}},
    {"roughness_of_two",
     [](GltfFile& f) { f.json["materials"][0]["pbrMetallicRoughness"]["roughnessFactor"] = 2; },
     {"materials[0].pbrMetallicRoughness.roughnessFactor"}},
    {"ior_below_one",
     [](GltfFile& f) { f.json["materials"][0]["extensions"]["KHR_materials_ior"]["ior"] = 0.5; },
     {"materials[0].extensions.KHR_materials_ior.ior"}},
    {"unknown_alpha_mode",
     [](GltfFile& f) { f.json["materials"][0]["alphaMode"] = "GLASS"; },
     {"materials[0].alphaMode", "GLASS"}},
    {"light_cones_reversed",
     [](GltfFile& f) {
       f.json["extensions"]["KHR_lights_punctual"]["lights"][0] = {
           {"type", "spot"}, {"spot", {{"innerConeAngle", 0.5}, {"outerConeAngle", 0.25}}}};
     },
     {"lights[0].spot"}},
    {"spot_without_cone",
     [](GltfFile& f) { f.json["extensions"]["KHR_lights_punctual"]["lights"][0]["type"] = "spot"; },
     {"lights[0].spot", "missing"}},
    {"joint_that_is_not_there",
     [](GltfFile& f) {
       const auto view =
           f.json["accessors"][f.primitive()["attributes"]["JOINTS_0"].get<int>()]["bufferView"]
               .get<std::size_t>();
       f.bytes[f.json["bufferViews"][view]["byteOffset"].get<std::size_t>()] = std::byte{5};
     },
     {"JOINTS_0", "joint 5"}},
    {"skin_without_joints",
     [](GltfFile& f) { f.json["skins"][0]["joints"] = json::array(); },
     {"skins[0].joints"}},
    {"fewer_matrices_than_joints",
     [](GltfFile& f) {
       f.json["skins"][0]["joints"] = {1, 2};
     },
     {"skins[0].inverseBindMatrices"}},
    {"morph_target_of_another_size",
     [](GltfFile& f) {
       f.primitive()["targets"][0]["POSITION"] = f.accessor<float>({1, 2, 3}, "VEC3");
     },
     {"targets[0].POSITION"}},
    {"extras_nested_too_deep",
     [](GltfFile& f) {
       json deep = 1;
       for (int i = 0; i < 300; ++i)
         deep = json::array({std::move(deep)});
       f.json["extras"] = std::move(deep);
     },
     {"levels deep"}},
    {"sparse_out_of_order",
     [](GltfFile& f) {
       const std::uint8_t places[] = {3, 3};
       const float moved[6] = {};
       f.json["accessors"][0]["sparse"] = {
           {"count", 2},
           {"indices", {{"bufferView", f.view(places, 2)}, {"componentType", 5121}}},
           {"values", {{"bufferView", f.view(moved, sizeof moved)}}}};
     },
     {"accessors[0].sparse.indices"}},
    {"sparse_beyond_the_end",
     [](GltfFile& f) {
       const std::uint8_t places[] = {200};
       const float moved[3] = {};
       f.json["accessors"][0]["sparse"] = {
           {"count", 1},
           {"indices", {{"bufferView", f.view(places, 1)}, {"componentType", 5121}}},
           {"values", {{"bufferView", f.view(moved, sizeof moved)}}}};
     },
     {"accessors[0].sparse.indices"}},
    {"draco_of_noise",
     [](GltfFile& f) {
       f.primitive()["extensions"]["KHR_draco_mesh_compression"] = {
           {"bufferView", 0}, {"attributes", {{"POSITION", 0}}}};
     },
     {"meshes[0].primitives[0].extensions.KHR_draco_mesh_compression"}},
    {"meshopt_of_noise",
     [](GltfFile& f) {
       f.json["bufferViews"][0]["extensions"]["EXT_meshopt_compression"] = {{"buffer", 0},
                                                                            {"byteLength", 16},
                                                                            {"byteStride", 12},
                                                                            {"count", 9},
                                                                            {"mode", "ATTRIBUTES"}};
     },
     {"bufferViews[0].extensions.EXT_meshopt_compression", "damaged"}},
    {"meshopt_of_four_gigabytes",
     [](GltfFile& f) {
       f.json["bufferViews"][0]["extensions"]["EXT_meshopt_compression"] = {{"buffer", 0},
                                                                            {"byteLength", 16},
                                                                            {"byteStride", 256},
                                                                            {"count", 1 << 30},
                                                                            {"mode", "ATTRIBUTES"}};
     },
     {"bufferViews[0].extensions.EXT_meshopt_compression", "MiB"}},
    {"meshopt_stride_of_three",
     [](GltfFile& f) {
       f.json["bufferViews"][0]["extensions"]["EXT_meshopt_compression"] = {{"buffer", 0},
                                                                            {"byteLength", 16},
                                                                            {"byteStride", 3},
                                                                            {"count", 9},
                                                                            {"mode", "TRIANGLES"}};
     },
     {"byteStride", "TRIANGLES"}},
};

INSTANTIATE_TEST_SUITE_P(scenes, BadScene, ::testing::ValuesIn(faults),
                         [](const auto& fault) { return std::string(fault.param.name); });

// What is wrong with a camera matters to those who look through it.
TEST(bad_camera, is_refused_where_it_is_used) {
  struct CameraFault {
    std::function<void(json&)> make;
    std::vector<std::string> message;
  };
  for (const CameraFault& fault : std::vector<CameraFault>{
           {[](json& camera) { camera.erase("perspective"); },
            {"cameras[0].perspective", "missing", "--eye"}},
           {[](json& camera) { camera["perspective"]["zfar"] = 0.01; }, {"cameras[0]", "ends at"}},
           {[](json& camera) { camera["perspective"]["yfov"] = 4; },
            {"cameras[0].perspective.yfov", "4"}},
           {[](json& camera) { camera = 5; }, {"cameras[0]"}},
           {[](json& camera) {
              camera = {{"type", "orthographic"},
                        {"orthographic", {{"xmag", 0}, {"ymag", 1}, {"znear", 0}, {"zfar", 1}}}};
            },
            {"cameras[0].orthographic", "magnification"}}}) {
    GltfFile file = sound();
    fault.make(file.json["cameras"][0]);
    const scene::Scene scene = scene::load(file.save());
    EXPECT_NO_THROW(scene::default_camera(scene, 1.0f));
    EXPECT_TRUE(
        fails_with(ExitCode::input, fault.message, [&] { scene::find_camera(scene, "0"); }));
  }
}

// Files that say little and ask for much work: they end, one way or the other, at once.
TEST(laborious_scene, long_list_in_many_primitives) {
  GltfFile file;
  const int indices = file.accessor(std::vector<std::uint8_t>(99'999, 0), "SCALAR");
  for (int i = 0; i < 500; ++i) {
    const int positions = file.accessor<float>({0, 0, 0, 1, 0, 0, 0, 1, 0}, "VEC3");
    file.mesh(
        {{"attributes", {{"POSITION", positions}, {"NORMAL", positions}}}, {"indices", indices}});
  }
  EXPECT_TRUE(fails_with(ExitCode::input, {"meshes[", "MiB"}, [&] { scene::load(file.save()); }));
}

TEST(laborious_scene, large_mesh_turned_many_times) {
  GltfFile file;
  file.mesh(plain(file, Grid(100)));
  for (int i = 1; i < 5000; ++i) {
    file.json["nodes"].push_back({{"mesh", 0}, {"rotation", {0.1, 0.2, 0.3, 0.9}}});
    file.json["scenes"][0]["nodes"].push_back(i);
  }
  const auto scene = scene::load(file.save());
  EXPECT_EQ(scene.instances.size(), 5000u);
  EXPECT_GT(scene.bounds.radius(), 70.0f);
  EXPECT_LT(scene.bounds.radius(), 300.0f);
}

TEST(bad_scene_file, missing) {
  EXPECT_TRUE(fails_with(ExitCode::input, {"nowhere.gltf"},
                         [] { scene::load(scratch_directory() / "nowhere.gltf"); }));
}

TEST(bad_scene_file, directory) {
  EXPECT_TRUE(fails_with(ExitCode::input, {"directory"}, [] { scene::load(scratch_directory()); }));
}

TEST(bad_scene_file, empty) {
  EXPECT_TRUE(fails_with(ExitCode::input, {"empty.glb", "empty"},
                         [] { scene::load(scratch_file("empty.glb", "")); }));
}

TEST(bad_scene_file, not_json) {
  EXPECT_TRUE(fails_with(ExitCode::input, {"line 2, column 3", "JSON"},
                         [] { scene::load(scratch_file("a.gltf", "{\n  oops")); }));
}

TEST(bad_scene_file, json_of_another_kind) {
  for (const char* text : {"[]", "5", "null", "{}", "\"glTF\""})
    EXPECT_TRUE(
        fails_with(ExitCode::input, {"asset"}, [&] { scene::load(scratch_file("a.gltf", text)); }));
}

TEST(bad_scene_file, number_out_of_range) {
  EXPECT_TRUE(fails_with(ExitCode::input, {"out of range"}, [] {
    scene::load(scratch_file("a.gltf", R"({"asset": {"version": "2.0"}, "scene": 1e999})"));
  }));
}

TEST(bad_scene_file, a_million_brackets) {
  EXPECT_TRUE(fails_with(ExitCode::input, {"levels deep"},
                         [] { scene::load(scratch_file("a.gltf", std::string(1'000'000, '['))); }));
}

TEST(bad_scene_file, binary_of_version_one) {
  std::string bytes = glb("{}", {});
  bytes[4] = 1;
  EXPECT_TRUE(fails_with(ExitCode::input, {"byte 4", "version 1"},
                         [&] { scene::load(scratch_file("a.glb", bytes)); }));
}

TEST(bad_scene_file, chunk_longer_than_the_file) {
  std::string bytes = glb("{}", {});
  bytes[14] = 1;
  EXPECT_TRUE(fails_with(ExitCode::input, {"byte 12", "chunk"},
                         [&] { scene::load(scratch_file("a.glb", bytes)); }));
}

} // namespace
