// Nodes, skins, morph targets, cameras, lights, framing.
#include "core/error.h"
#include "scene/framing.h"
#include "scene/gltf_file.h"
#include "scene/load.h"
#include "scene/origin.h"
#include "support/errors.h"
#include "support/scratch.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

using namespace gg;
using namespace gg::test;

namespace {

constexpr float quarter = std::numbers::sqrt2_v<float> / 2; // sin and cos of a quarter turn's half

const nlohmann::json about_z = {0, 0, quarter, quarter}; // a quarter turn: x to y

TEST(nodes, transforms_multiply_down_the_tree) {
  GltfFile file;
  const int leaf = file.triangle();
  file.json["nodes"][leaf]["translation"] = {1, 0, 0};
  file.json["nodes"].push_back({{"rotation", about_z}, {"children", {leaf}}});
  file.json["nodes"].push_back({{"scale", {2, 2, 2}}, {"children", {leaf + 1}}});
  file.json["scenes"][0]["nodes"] = {leaf + 2};
  const auto scene = scene::load(file.save());
  ASSERT_EQ(scene.instances.size(), 1u);
  // (0,0,0) -> (1,0,0) -> (0,1,0) -> (0,2,0)
  const glm::vec4 p = scene.instances[0].world * glm::vec4(0, 0, 0, 1);
  EXPECT_LT(glm::length(p - glm::vec4(0, 2, 0, 1)), rounding);
}

TEST(nodes, matrices_are_column_by_column) {
  GltfFile file;
  const int node = file.triangle();
  file.json["nodes"][node]["matrix"] = {0, 1, 0, 0, -1, 0, 0, 0, 0, 0, 1, 0, 5, 6, 7, 1};
  const auto scene = scene::load(file.save());
  EXPECT_EQ(scene.instances[0].world * glm::vec4(1, 0, 0, 1), glm::vec4(5, 7, 7, 1));
}

TEST(nodes, negative_scale_mirrors) {
  GltfFile file;
  file.triangle();
  file.json["nodes"].push_back({{"mesh", 0}, {"scale", {-1, 1, 1}}});
  file.json["nodes"].push_back({{"mesh", 0}, {"scale", {-1, -1, 1}}});
  file.json["scenes"][0]["nodes"] = {0, 1, 2};
  const auto scene = scene::load(file.save());
  EXPECT_FALSE(scene.instances[0].mirrored);
  EXPECT_TRUE(scene.instances[1].mirrored);
  EXPECT_FALSE(scene.instances[2].mirrored);
  EXPECT_EQ(scene.meshes.size(), 1u);
}

TEST(nodes, only_the_default_scene_is_loaded) {
  GltfFile file;
  file.triangle();
  file.json["nodes"].push_back({{"mesh", 0}});
  file.json["scenes"].push_back({{"nodes", {1}}});
  file.json["scene"] = 1;
  EXPECT_EQ(scene::load(file.save()).instances.size(), 1u);
  file.json.erase("scene");
  file.json.erase("scenes");
  EXPECT_EQ(scene::load(file.save()).instances.size(), 2u);
}

TEST(nodes, a_chain_of_a_hundred_thousand_is_no_problem) {
  GltfFile file;
  file.triangle();
  auto& nodes = file.json["nodes"];
  for (int i = 1; i < 100000; ++i)
    nodes.push_back({{"children", {i - 1}}});
  file.json["scenes"][0]["nodes"] = {99999};
  EXPECT_EQ(scene::load(file.save()).instances.size(), 1u);
}

TEST(nodes, bounds_are_those_of_the_vertices_in_the_world) {
  GltfFile file;
  file.triangle();
  file.json["nodes"][0]["rotation"] = {0, 0, std::sin(std::numbers::pi / 8),
                                       std::cos(std::numbers::pi / 8)};
  const auto bounds = scene::load(file.save()).bounds;
  // The triangle (0,0) (1,0) (0,1) turned by 45°: its box would be larger.
  EXPECT_NEAR(bounds.high.y, quarter, rounding);
  EXPECT_NEAR(bounds.low.x, -quarter, rounding);
  EXPECT_NEAR(bounds.low.y, 0.0f, rounding);
}

// Two joints: one at rest, one moved up by 1; the vertex between them goes half the way.
GltfFile skinned() {
  GltfFile file;
  file.triangle();
  auto& attributes = file.primitive()["attributes"];
  attributes["NORMAL"] = file.accessor<float>({0, 0, 1, 0, 0, 1, 0, 0, 1}, "VEC3");
  attributes["JOINTS_0"] =
      file.accessor<std::uint8_t>({0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0}, "VEC4");
  attributes["WEIGHTS_0"] =
      file.accessor<float>({1, 0, 0, 0, 0, 1, 0, 0, 0.5f, 0.5f, 0, 0}, "VEC4");
  std::vector<float> inverse_binds;
  for (int joint = 0; joint < 2; ++joint)
    for (int i = 0; i < 16; ++i)
      inverse_binds.push_back(i % 5 == 0 ? 1.0f : 0.0f);
  file.json["nodes"].push_back(nlohmann::json::object());
  file.json["nodes"].push_back({{"translation", {0, 0, 1}}});
  file.json["scenes"][0]["nodes"] = {0, 1, 2};
  file.json["nodes"][0]["skin"] = 0;
  file.json["nodes"][0]["translation"] = {100, 0, 0}; // does not matter for a skin
  file.json["skins"] = {
      {{"joints", {1, 2}}, {"inverseBindMatrices", file.accessor(inverse_binds, "MAT4")}}};
  return file;
}

TEST(skins, put_vertices_where_their_joints_are) {
  const auto scene = scene::load(skinned().save());
  EXPECT_EQ(scene.instances.at(0).world, glm::mat4(1));
  const auto c = corners(scene, first(scene));
  EXPECT_EQ(c[0], glm::vec3(0, 0, 0));
  EXPECT_EQ(c[1], glm::vec3(1, 0, 1));
  EXPECT_EQ(c[2], glm::vec3(0, 1, 0.5));
}

TEST(skins, turn_normals_with_the_joints) {
  auto file = skinned();
  file.json["nodes"][2] = {{"rotation", {quarter, 0, 0, quarter}}}; // z to -y
  const auto scene = scene::load(file.save());
  const auto& p = first(scene);
  EXPECT_LT(glm::length(vec3_at(scene, p.normals, 1) - glm::vec3(0, -1, 0)), rounding);
}

TEST(skins, that_mirror_turn_the_front_face_round) {
  auto file = skinned();
  for (const int joint : {1, 2})
    file.json["nodes"][joint]["scale"] = {-1, 1, 1};
  EXPECT_TRUE(scene::load(file.save()).instances.at(0).mirrored);
}

TEST(skins, with_a_joint_that_is_not_there_are_refused) {
  auto file = skinned();
  file.json["skins"][0]["joints"] = {1};
  EXPECT_TRUE(fails_with(ExitCode::input,
                         {"meshes[0].primitives[0].attributes.JOINTS_0", "joint 1"},
                         [&] { scene::load(file.save()); }));
}

TEST(morphs, add_their_weighted_offsets) {
  GltfFile file;
  file.triangle();
  const int up = file.accessor<float>({0, 0, 1, 0, 0, 1, 0, 0, 1}, "VEC3");
  const int right = file.accessor<float>({1, 0, 0, 0, 0, 0, 0, 0, 0}, "VEC3");
  file.primitive()["targets"] = {{{"POSITION", up}}, {{"POSITION", right}}};
  file.json["meshes"][0]["weights"] = {0.5, 2};
  const auto c = corners(scene::load(file.save()), first(scene::load(file.save())));
  EXPECT_EQ(c[0], glm::vec3(2, 0, 0.5));
  EXPECT_EQ(c[1], glm::vec3(1, 0, 0.5));

  file.json["nodes"][0]["weights"] = {0, 0}; // the node has the last word
  const auto still = scene::load(file.save());
  EXPECT_EQ(corners(still, first(still))[0], glm::vec3(0, 0, 0));
}

TEST(morphs, turn_flat_normals_with_the_triangle) {
  GltfFile file;
  file.triangle();
  // (0,1,0) goes to (0,0,1): the triangle now lies in the xz plane.
  const int target = file.accessor<float>({0, 0, 0, 0, 0, 0, 0, -1, 1}, "VEC3");
  file.primitive()["targets"] = {{{"POSITION", target}}};
  file.json["meshes"][0]["weights"] = {1};
  const auto scene = scene::load(file.save());
  EXPECT_EQ(vec3_at(scene, first(scene).normals, 0), glm::vec3(0, -1, 0));
}

TEST(cameras, stand_where_their_nodes_are_and_ignore_scale) {
  GltfFile file;
  file.triangle();
  file.json["cameras"] = {
      {{"type", "perspective"}, {"perspective", {{"yfov", 0.5}, {"znear", 0.1}, {"zfar", 9}}}},
      {{"type", "orthographic"},
       {"name", "plan"},
       {"orthographic", {{"xmag", 2}, {"ymag", 3}, {"znear", 0}, {"zfar", 5}}}}};
  file.json["nodes"].push_back({{"name", "front"},
                                {"camera", 0},
                                {"translation", {1, 2, 3}},
                                {"rotation", about_z},
                                {"scale", {5, 6, 7}}});
  file.json["nodes"].push_back({{"camera", 1}});
  file.json["scenes"][0]["nodes"] = {0, 1, 2};
  const auto scene = scene::load(file.save());
  ASSERT_EQ(scene.cameras.size(), 2u);
  const auto& c = scene.cameras[0];
  EXPECT_EQ(c.name, "front");
  EXPECT_EQ(c.fovy, 0.5f);
  EXPECT_EQ(c.near, 0.1f);
  EXPECT_EQ(c.far, 9.0f);
  EXPECT_EQ(glm::vec3(c.world[3]), glm::vec3(1, 2, 3));
  EXPECT_LT(glm::length(glm::vec3(c.world[0]) - glm::vec3(0, 1, 0)), rounding);
  EXPECT_LT(glm::length(glm::vec3(c.world[2]) - glm::vec3(0, 0, 1)), rounding);
  EXPECT_TRUE(scene.cameras[1].orthographic);
  EXPECT_EQ(scene.cameras[1].name, "plan");
  EXPECT_EQ(scene.cameras[1].magnification, glm::vec2(2, 3));

  EXPECT_EQ(&scene::find_camera(scene, "plan"), &scene.cameras[1]);
  EXPECT_EQ(&scene::find_camera(scene, "0"), &scene.cameras[0]);
  for (const char* wrong : {"2", "-1", "back", ""})
    EXPECT_TRUE(fails_with(ExitCode::usage, {"front", "plan"}, [&] {
      scene::find_camera(scene, wrong);
    })) << wrong;
}

// The same place in the camera's frame, however far both are from the origin, where the file says it exactly: by its nodes, or
// by its vertices.
TEST(origin, far_from_it_nothing_is_lost) {
  constexpr float far = 1048576.0f; // 2^20: floats of its size are 1/8 apart
  for (const bool by_vertices : {false, true}) {
    GltfFile file;
    std::vector<float> triangle{0, 0, 0, 1, 0.25f, 0, 0, 1, 0.5f};
    if (by_vertices)
      for (std::size_t i = 0; i < triangle.size(); i += 3)
        triangle[i] += far;
    file.mesh({{"attributes", {{"POSITION", file.accessor(triangle, "VEC3")}}}});
    file.json["nodes"][0]["rotation"] = about_z;
    if (!by_vertices) file.json["nodes"][0]["translation"] = {0, far, 0};
    auto scene = scene::load(file.save());
    scene::Camera camera = scene::look_at(scene, {0, far, 4}, {0, far, 0}, {0, 1, 0}, 1.0f);
    scene::move_origin_to(camera, scene);
    EXPECT_EQ(camera.world[3], glm::vec4(0, 0, 0, 1));
    const auto c = corners(scene, first(scene));
    const glm::vec3 wanted[] = {{0, 0, -4}, {-.25f, 1, -4}, {-1, 0, -3.5f}};
    for (std::size_t i = 0; i < 3; ++i) {
      const glm::vec3 p(scene.instances[0].world * glm::vec4(c[i], 1));
      EXPECT_LT(glm::length(p - wanted[i]), by_vertices ? 0.2f : rounding) << i;
      // The rotation's own rounding times the distance is the same for all vertices: shapes stay.
      const glm::vec3 q(scene.instances[0].world * glm::vec4(c[0], 1));
      EXPECT_LT(glm::length((p - q) - (wanted[i] - wanted[0])), 3 * rounding) << i;
    }
    EXPECT_LT(glm::length(scene.bounds.centre()), 8.0f);
  }
}

// Wherever it has been before: a window moves it with its camera, and draws what capture draws.
TEST(origin, moved_again_is_as_moved_once) {
  const auto loaded = scene::load(asset("scenes/GlassVaseFlowers.glb"));
  const glm::vec3 to(0.1f, 20.3f, -0.7f);
  scene::Scene once = loaded, again = loaded;
  scene::move_origin(once, to);
  scene::Origin origin(again);
  for (const glm::vec3& at : {glm::vec3(1e5f, 1.1f, 0.3f), glm::vec3(0.0f), to})
    origin.move_to(at);
  ASSERT_FALSE(once.instances.empty());
  for (std::size_t i = 0; i < once.instances.size(); ++i)
    EXPECT_EQ(once.instances[i].world, again.instances[i].world);
  for (std::size_t i = 0; i < once.lights.size(); ++i)
    EXPECT_EQ(once.lights[i].position, again.lights[i].position);
  EXPECT_EQ(once.bounds.low, again.bounds.low);
  EXPECT_EQ(once.bounds.high, again.bounds.high);
}

TEST(lights, are_read_with_their_place_and_direction) {
  GltfFile file;
  file.triangle();
  file.json["extensions"]["KHR_lights_punctual"]["lights"] = {
      {{"type", "directional"}, {"intensity", 3}, {"color", {1, 0.5, 0}}},
      {{"type", "point"}, {"range", 4}},
      {{"type", "spot"}, {"spot", {{"innerConeAngle", 0.25}, {"outerConeAngle", 0.5}}}}};
  for (int i = 0; i < 3; ++i)
    file.json["nodes"].push_back({{"extensions", {{"KHR_lights_punctual", {{"light", i}}}}},
                                  {"translation", {0, i, 0}},
                                  {"scale", {2, 2, 2}},
                                  {"rotation", {-quarter, 0, 0, quarter}}}); // -z to -y: down
  file.json["scenes"][0]["nodes"] = {0, 1, 2, 3};
  const auto scene = scene::load(file.save());
  ASSERT_EQ(scene.lights.size(), 3u);
  EXPECT_EQ(scene.lights[0].kind, scene::LightKind::directional);
  EXPECT_EQ(scene.lights[0].intensity, glm::vec3(3, 1.5, 0));
  EXPECT_LT(glm::length(scene.lights[0].direction - glm::vec3(0, -1, 0)), rounding);
  EXPECT_EQ(scene.lights[1].range, 4.0f);
  EXPECT_EQ(scene.lights[0].range, INFINITY);
  EXPECT_EQ(scene.lights[2].position, glm::vec3(0, 2, 0));
  EXPECT_EQ(scene.lights[2].inner_cone, 0.25f);
  EXPECT_EQ(scene.lights[2].outer_cone, 0.5f);
}

// Every corner of the bounds falls into the picture, and none is needlessly far from its edge.
TEST(framing, shows_the_whole_scene_and_little_else) {
  for (const char* name :
       {"shaderball.glb", "MetalRoughSpheresNoTextures.glb", "GlassVaseFlowers.glb"})
    for (const float aspect : {0.5f, 1.0f, 16.0f / 9.0f}) {
      const auto scene = scene::load(asset(std::string("scenes/") + name));
      const auto camera = scene::default_camera(scene, aspect);
      const glm::mat4 view = glm::inverse(camera.world);
      float widest = 0.0f;
      for (int i = 0; i < 8; ++i) {
        const auto& b = scene.bounds;
        const glm::vec4 p = view
                            * glm::vec4(i & 1 ? b.high.x : b.low.x, i & 2 ? b.high.y : b.low.y,
                                        i & 4 ? b.high.z : b.low.z, 1);
        EXPECT_GT(-p.z, camera.near);
        EXPECT_LT(-p.z, camera.far);
        const float t = std::tan(camera.fovy / 2);
        widest = std::max({widest, std::abs(p.y / p.z) / t, std::abs(p.x / p.z) / (t * aspect)});
      }
      EXPECT_LT(widest, 1.0f) << name << aspect;
      EXPECT_GT(widest, 0.8f) << name << aspect;
      EXPECT_LT(camera.far / camera.near, 2100.0f);
    }
}

scene::Scene boxed(const glm::vec3& half) {
  scene::Scene scene;
  scene.bounds.include(-half);
  scene.bounds.include(half);
  return scene;
}

TEST(framing, sees_a_flat_scene_from_its_broad_side) {
  const auto back = [](const glm::vec3& half) {
    return glm::vec3(scene::default_camera(boxed(half), 1.5f).world[2]);
  };
  EXPECT_EQ(back({1, 2, 0}), glm::vec3(0, 0, 1));
  EXPECT_EQ(back({3, 0, 2}), glm::vec3(0, 1, 0));
  EXPECT_EQ(back({0.01f, 1, 2}), glm::vec3(1, 0, 0));
  EXPECT_EQ(back({1, 0.3f, 1}), glm::vec3(0, 0, 1)); // an object that lies is none
  for (const glm::vec3 half : {glm::vec3(1, 2, 0), glm::vec3(3, 0, 2), glm::vec3(0, 1, 2)})
    for (const float aspect : {0.1f, 1.0f, 10.0f}) {
      const auto camera = scene::default_camera(boxed(half), aspect);
      EXPECT_NEAR(glm::determinant(glm::mat3(camera.world)), 1.0f, rounding);
      const glm::mat4 view = glm::inverse(camera.world);
      float widest = 0.0f;
      for (const glm::vec3 corner : {half, -half}) {
        const glm::vec4 p = view * glm::vec4(corner, 1);
        const float t = std::tan(camera.fovy / 2);
        widest = std::max({widest, std::abs(p.y / p.z) / t, std::abs(p.x / p.z) / (t * aspect)});
      }
      EXPECT_LT(widest, 1.0f);
      EXPECT_GT(widest, 0.8f);
    }
}

// A triangle of a large scene that is close to the eye, facing it, aslant, or reaching past it.
TEST(framing, near_plane_lies_before_what_the_camera_stands_before) {
  const auto scene_with = [](const std::vector<float>& triangle) {
    GltfFile file;
    file.triangle();
    file.json["nodes"][0]["scale"] = {700, 700, 700};
    file.json["nodes"][0]["translation"] = {-300, -300, -300};
    file.mesh({{"attributes", {{"POSITION", file.accessor(triangle, "VEC3")}}}});
    return scene::load(file.save());
  };
  const auto near_of = [&](const std::vector<float>& triangle) {
    return scene::look_at(scene_with(triangle), {0, 0, 0}, {0, 0, -1}, {0, 1, 0}, 1.0f).near;
  };
  EXPECT_LT(near_of({0, 0, -.1f, .1f, 0, -.1f, 0, .1f, -.1f}), .1f);
  EXPECT_GT(near_of({0, 0, -.1f, .1f, 0, -.1f, 0, .1f, -.1f}), .05f);
  EXPECT_LT(near_of({0, 0, -.05f, .1f, 0, -.3f, 0, .1f, -.3f}), .05f);
  // A floor under the eye, .1 m down, that is seen from .1 m / tan 30 degrees on.
  const float floor = near_of({-5, -.1f, 5, 5, -.1f, 5, 0, -.1f, -5});
  EXPECT_LT(floor, .1f / std::tan(.5f));
  EXPECT_GT(floor, .01f);
  // Behind the eye is nothing that is seen.
  EXPECT_GT(near_of({0, 0, .1f, .1f, 0, .1f, 0, .1f, .1f}), .3f);
  // What the eye touches leaves the near plane a place.
  EXPECT_GT(near_of({-1, 0, 1, 1, 0, 1, 0, 0, -1}), 0.0f);
}

TEST(framing, of_an_empty_scene_looks_at_the_origin) {
  const auto camera = scene::default_camera(scene::Scene{}, 1.0f);
  EXPECT_GT(camera.world[3].z, 1.0f);
  EXPECT_GT(camera.near, 0.0f);
  EXPECT_GT(camera.far, camera.near);
}

TEST(framing, looks_where_it_is_told) {
  const scene::Scene scene;
  const auto camera = scene::look_at(scene, {3, 0, 0}, {0, 0, 0}, {0, 1, 0}, 1.0f);
  EXPECT_EQ(-glm::vec3(camera.world[2]), glm::vec3(-1, 0, 0));
  EXPECT_EQ(glm::vec3(camera.world[0]), glm::vec3(0, 0, -1));
  EXPECT_NEAR(glm::determinant(glm::mat3(camera.world)), 1.0f, rounding);
  const auto refuses = [&](glm::vec3 eye, glm::vec3 up, float fovy, const char* part) {
    EXPECT_TRUE(fails_with(ExitCode::usage, {part}, [&] {
      scene::look_at(scene, eye, {0, 0, 0}, up, fovy);
    }));
  };
  refuses({0, 0, 0}, {0, 1, 0}, 1.0f, "same point");
  refuses({0, 3, 0}, {0, 1, 0}, 1.0f, "up");
  refuses({3, 0, 0}, {0, 1, 0}, 0.0f, "fovy");
  refuses({3, 0, 0}, {0, 1, 0}, NAN, "fovy");
  refuses({NAN, 0, 0}, {0, 1, 0}, 1.0f, "same point");
}

} // namespace
