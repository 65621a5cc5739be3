// Animations: where glTF 2.0 §3.11 and appendix C put nodes, skins and morph targets at a time.
#include "scene/gltf_file.h"
#include "scene/load.h"
#include "support/errors.h"

#include <gtest/gtest.h>

#include <cmath>

namespace gg::test {
namespace {

// A triangle and an animation of node 0 along `path`.
struct Moving {
  GltfFile file;
  Moving() { file.triangle(); }
  Moving& channel(const std::string& path, const std::vector<float>& times,
                  const std::vector<float>& values, const std::string& type,
                  const std::string& interpolation = "LINEAR", int node = 0) {
    auto& animations = file.json["animations"];
    if (animations.empty())
      animations.push_back({{"name", "walk"},
                            {"channels", nlohmann::json::array()},
                            {"samplers", nlohmann::json::array()}});
    auto& animation = animations.back();
    animation["channels"].push_back(
        {{"sampler", animation["samplers"].size()}, {"target", {{"node", node}, {"path", path}}}});
    animation["samplers"].push_back({{"input", file.accessor(times, "SCALAR")},
                                     {"output", file.accessor(values, type)},
                                     {"interpolation", interpolation}});
    return *this;
  }
  scene::Scene at(float time, const std::string& animation = {}) const {
    return scene::load(file.save(), scene::Instant{time, animation});
  }
  glm::vec3 place(float time) const { return at(time).instances.at(0).world[3]; }
};

void expect_near(const glm::vec3& a, const glm::vec3& b) {
  EXPECT_LT(glm::length(a - b), 4.0f * rounding)
      << a.x << " " << a.y << " " << a.z << ", not " << b.x << " " << b.y << " " << b.z;
}

} // namespace

TEST(animation, linear_keys_are_joined_by_straight_lines_and_stand_still_outside) {
  Moving m;
  m.channel("translation", {1, 2, 4}, {0, 0, 0, 1, 0, 0, 1, 4, 0}, "VEC3");
  expect_near(m.place(1.5f), {0.5f, 0, 0});
  expect_near(m.place(3.0f), {1, 2, 0});
  expect_near(m.place(2.0f), {1, 0, 0});
  expect_near(m.place(-7.0f), {0, 0, 0});
  expect_near(m.place(9.0f), {1, 4, 0});
  EXPECT_EQ(m.at(0.0f).posed->end, 4.0f);
  EXPECT_EQ(m.at(0.0f).posed->animation, "walk");
}

TEST(animation, steps_hold_their_value_until_the_next_key) {
  Moving m;
  m.channel("scale", {0, 1}, {1, 1, 1, 3, 3, 3}, "VEC3", "STEP");
  EXPECT_EQ(m.at(0.999f).instances.at(0).world[0][0], 1.0f);
  EXPECT_EQ(m.at(1.0f).instances.at(0).world[0][0], 3.0f);
}

TEST(animation, cubic_splines_are_hermites_with_tangents_per_second) {
  // x = t³ from 0 to 2: value, tangent 0, 0 and 8, 12.
  Moving m;
  m.channel("translation", {0, 2}, {9, 9, 9, 0, 0, 0, 0, 0, 0, 12, 0, 0, 8, 0, 0, 9, 9, 9}, "VEC3",
            "CUBICSPLINE");
  for (const float t : {0.0f, 0.25f, 1.0f, 1.75f, 2.0f})
    expect_near(m.place(t), {t * t * t, 0, 0});
}

TEST(animation, rotations_take_the_shorter_arc_at_an_even_pace) {
  // A quarter turn about z, its end written as the other quaternion of the same rotation.
  const float h = std::sqrt(0.5f);
  Moving m;
  m.channel("rotation", {0, 1}, {0, 0, 0, 1, 0, 0, -h, -h}, "VEC4");
  const float angle = 0.25f * 1.57079633f;
  expect_near(m.at(0.25f).instances.at(0).world[0], {std::cos(angle), std::sin(angle), 0});
}

TEST(animation, moves_children_with_their_parents_and_cameras_too) {
  Moving m;
  m.file.json["nodes"].push_back({{"camera", 0}});
  m.file.json["nodes"][0]["children"] = {1};
  m.file.json["cameras"] = {
      {{"type", "perspective"}, {"perspective", {{"yfov", 1}, {"znear", 1}}}}};
  m.channel("translation", {0, 1}, {0, 0, 0, 2, 0, 0}, "VEC3");
  expect_near(m.at(0.5f).cameras.at(0).world[3], {1, 0, 0});
}

TEST(animation, weights_move_morph_targets) {
  Moving m;
  const int up = m.file.accessor<float>({0, 0, 1, 0, 0, 1, 0, 0, 1}, "VEC3");
  const int right = m.file.accessor<float>({1, 0, 0, 0, 0, 0, 0, 0, 0}, "VEC3");
  m.file.primitive()["targets"] = {{{"POSITION", up}}, {{"POSITION", right}}};
  m.channel("weights", {0, 1}, {0, 0, 1, 2}, "SCALAR");
  const scene::Scene scene = m.at(0.5f);
  expect_near(corners(scene, first(scene))[0], {1, 0, 0.5f});
}

TEST(animation, joints_move_skins) {
  Moving m;
  auto& attributes = m.file.primitive()["attributes"];
  attributes["JOINTS_0"] =
      m.file.accessor<std::uint8_t>({0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0}, "VEC4");
  attributes["WEIGHTS_0"] = m.file.accessor<float>({1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0}, "VEC4");
  m.file.json["nodes"].push_back(nlohmann::json::object());
  m.file.json["scenes"][0]["nodes"] = {0, 1};
  m.file.json["nodes"][0]["skin"] = 0;
  m.file.json["skins"] = {{{"joints", {1}}}};
  m.channel("translation", {0, 1}, {0, 0, 0, 0, 0, 2}, "VEC3", "LINEAR", 1);
  const scene::Scene scene = m.at(0.5f);
  expect_near(corners(scene, first(scene))[1], {1, 0, 1});
}

TEST(animation, is_found_by_name_or_index_and_listed_if_it_is_not_there) {
  Moving m;
  m.channel("translation", {0, 1}, {0, 0, 0, 1, 0, 0}, "VEC3");
  m.file.json["animations"].push_back(m.file.json["animations"][0]);
  m.file.json["animations"][1]["name"] = "run";
  EXPECT_EQ(m.at(0.0f, "run").posed->animation, "run");
  EXPECT_EQ(m.at(0.0f, "1").posed->animation, "run");
  EXPECT_TRUE(fails_with(ExitCode::usage, {"no animation 'fly'", "0 (walk), 1 (run)"},
                         [&] { m.at(0.0f, "fly"); }));
  EXPECT_TRUE(fails_with(ExitCode::usage, {"has no animations"}, [] { Moving().at(0.0f); }));
}

TEST(animation, that_is_not_sound_is_refused_by_its_place_and_only_where_it_is_played) {
  const auto broken = [](auto&& change, const std::vector<std::string>& parts) {
    Moving m;
    m.channel("translation", {0, 1}, {0, 0, 0, 1, 0, 0}, "VEC3");
    change(m, m.file.json["animations"][0]);
    EXPECT_NO_THROW(scene::load(m.file.save()));
    EXPECT_TRUE(fails_with(ExitCode::input, parts, [&] { m.at(0.5f); }));
  };
  broken([](Moving&, auto& a) { a["channels"][0]["sampler"] = 7; }, {"channels[0].sampler", "7"});
  broken([](Moving&, auto& a) { a["channels"][0]["target"]["node"] = 7; }, {"target.node"});
  broken([](Moving&, auto& a) { a["samplers"][0]["input"] = 99; }, {"samplers[0].input"});
  broken([](Moving&, auto& a) { a["samplers"][0]["interpolation"] = "SOFT"; }, {"SOFT"});
  broken([](Moving&, auto& a) { a.erase("samplers"); }, {"samplers", "missing"});
  broken(
      [](Moving& m, auto& a) {
        a["samplers"][0]["input"] = m.file.template accessor<float>({1, 0}, "SCALAR");
      },
      {"samplers[0].input", "go back"});
  broken(
      [](Moving& m, auto& a) {
        a["samplers"][0]["output"] = m.file.template accessor<float>({1, 0, 0}, "VEC3");
      },
      {"samplers[0].output", "3 numbers for 2 keys"});
  broken(
      [](Moving& m, auto&) {
        m.file.json["nodes"][0]["matrix"] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
      },
      {"nodes[0].matrix", "moves it"});
  broken(
      [](Moving& m, auto& a) {
        a["channels"][0]["target"]["path"] = "rotation";
        a["samplers"][0]["output"] =
            m.file.template accessor<float>({0, 0, 0, 1, 0, 0, 0, 0}, "VEC4");
      },
      {"samplers[0].output", "key 1", "length 0"});
}

TEST(animation, of_what_is_not_known_is_passed_over) {
  Moving m;
  m.channel("translation", {0, 1}, {0, 0, 0, 1, 0, 0}, "VEC3");
  m.channel("pointer", {0, 1}, {0, 1}, "SCALAR");
  expect_near(m.place(0.5f), {0.5f, 0, 0});
}

} // namespace gg::test
