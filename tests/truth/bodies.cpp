// What app/README.md's "Bodies of glass" says: which parts bound one body, walls that two share, alpha on a
// body, sheets with a thickness.
#include "scene/bodies.h"

#include "truth/estimate.h"
#include "truth/scenes.h"

namespace {

using namespace gg;
using namespace gg::truth;
using namespace gg::truth::test;

const Ray down_z{{0.1, 0.05, 5.0}, {0.0, 0.0, -1.0}};

// Black but for a white half above: what bends light changes what is seen.
EnvironmentLight half_white() {
  environment::Map map = black_map(64, 32);
  for (int y = 0; y < 16; ++y)
    for (int x = 0; x < 64; ++x)
      std::fill_n(texel(map, x, y), 3, 1.0f);
  return EnvironmentLight(std::move(map), 0.0, 1.0);
}

// The ball's one mesh in two parts of two materials: its upper and its lower triangles.
scene::Scene ball_in_two_parts(const scene::Material& upper, const scene::Material& lower) {
  scene::Scene scene;
  add_ball(scene, upper, glm::vec3(0.0f), 1.0f, 16);
  scene::Mesh& mesh = scene.meshes[0];
  const scene::Indices all = scene.indices[0];
  const auto half = all.begin() + static_cast<std::ptrdiff_t>(all.size() / 6 * 3);
  scene.indices[0] = scene::Indices(all.begin(), half);
  scene.indices.push_back(scene::Indices(half, all.end()));
  scene.materials.push_back(lower);
  mesh.primitives.push_back(mesh.primitives[0]);
  mesh.primitives[1].indices = 1;
  mesh.primitives[1].material = 1;
  return scene;
}

TEST(truth_bodies, two_materials_on_one_closed_mesh_bound_one_body) {
  const scene::Scene scene = ball_in_two_parts(glass(0.0f), glass(0.0f));
  EXPECT_EQ(scene::body_materials(scene), (std::vector<scene::Index>{0, 0}));
  scene::Scene whole;
  add_ball(whole, glass(0.0f), glm::vec3(0.0f), 1.0f, 16);
  const EnvironmentLight light = half_white();
  const Integrator parts = integrator_of(scene, &light), one = integrator_of(whole, &light);
  for (const double y : {-0.8, -0.3, 0.3, 0.8}) {
    const Ray ray{{0.1, y, 5.0}, {0.0, 0.0, -1.0}};
    EXPECT_EQ(trace(parts, ray, 200).mean, trace(one, ray, 200).mean) << y;
  }
}

TEST(truth_bodies, two_closed_parts_of_one_mesh_stay_two) {
  scene::Scene scene;
  add_ball(scene, glass(0.0f), glm::vec3(0.0f), 1.0f, 8);
  add_ball(scene, glass(0.0f), glm::vec3(0.0f), 0.5f, 8);
  scene.meshes[0].primitives.push_back(scene.meshes[1].primitives[0]);
  EXPECT_EQ(scene::body_materials(scene), (std::vector<scene::Index>{0, 1}));
}

TEST(truth_bodies, sheets_have_no_inside_and_nearly_closed_meshes_do) {
  scene::Scene scene;
  add_sheet(scene, glass(0.0f), 1.0f, 0.0f);
  add_ball(scene, glass(0.0f), glm::vec3(0.0f), 1.0f, 16);
  add_ball(scene, glass(0.0f), glm::vec3(0.0f), 1.0f, 16);
  add_ball(scene, glass(0.0f), glm::vec3(0.0f), 1.0f, 16);
  scene.indices[2].erase(scene.indices[2].begin(), scene.indices[2].begin() + 3); // a hole
  scene.indices[3].resize(scene.indices[3].size() / 6 * 3);                       // half of it
  scene::Bodies bodies(scene);
  EXPECT_FALSE(bodies.has_inside(0, 0));
  EXPECT_TRUE(bodies.has_inside(1, 1));
  EXPECT_TRUE(bodies.has_inside(2, 2));
  EXPECT_FALSE(bodies.has_inside(3, 3));
}

// A drink in a glass: where they share a wall it is as if the drink reached into the glass.
TEST(truth_bodies, walls_that_two_solids_share_belong_to_the_smaller) {
  const auto seen = [](float reach) {
    scene::Scene scene;
    scene::Material drink = glass(0.0f);
    drink.ior = 1.33f;
    drink.attenuation_color = {0.9f, 0.5f, 0.1f};
    drink.attenuation_distance = 1.0f;
    add_box(scene, glass(0.0f), {0.0f, 0.0f, 1.0f}, {2.0f, 2.0f, 1.0f}); // z from 0 to 2
    add_box(scene, drink, {0.0f, 0.0f, -0.5f + 0.5f * reach}, {1.0f, 1.0f, 0.5f + 0.5f * reach});
    const EnvironmentLight white = constant_environment(glm::vec3(1.0f));
    const Integrator integrator = integrator_of(scene, &white);
    std::vector<glm::dvec3> means;
    for (int k = 0; k < 40; ++k)
      means.push_back(
          trace(integrator, {{-0.9 + 0.045 * k, 0.013 * k, 5.0}, {0.0, 0.0, -1.0}}, 64).mean);
    return means;
  };
  // Reaching in by a thousandth of its depth the drink absorbs by a thousandth more.
  constexpr double deeper = 0.005;
  const auto shared = seen(0.0f), reaching = seen(1e-3f);
  for (std::size_t k = 0; k < shared.size(); ++k)
    for (int c = 0; c < 3; ++c)
      EXPECT_NEAR(shared[k][c], reaching[k][c], deeper) << "ray " << k << ", channel " << c;
}

TEST(truth_bodies, what_is_opaque_covers_the_wall_that_it_lies_on) {
  scene::Scene scene;
  add_box(scene, glass(0.0f), {0.0f, 0.0f, 1.0f}, {1.0f, 1.0f, 1.0f});
  add_sheet(scene, unlit(0.5f), 3.0f, 0.0f); // the floor that it stands on
  const Integrator integrator = integrator_of(scene, nullptr);
  for (int k = 0; k < 40; ++k) {
    const glm::dvec3 from(-0.9 + 0.045 * k, 0.013 * k, 5.0);
    // All that comes is the floor's, through one interface: 1 - F, and radiance is kept within.
    const Estimate e = trace(integrator, {from, {0.0, 0.0, -1.0}}, 64);
    EXPECT_NEAR(e.mean.x, 0.96 * 0.5 / 2.25, 1e-3) << k;
  }
}

TEST(truth_bodies, alpha_says_once_whether_a_body_is_there) {
  scene::Material half = glass(0.0f);
  half.alpha_mode = scene::AlphaMode::blend;
  half.base_color.w = 0.4f;
  half.attenuation_color = glm::vec3(0.1f);
  half.attenuation_distance = 1.0f;
  scene::Scene with, without;
  add_ball(with, half, glm::vec3(0.0f), 1.0f, 32);
  add_sheet(with, unlit(0.5f), 9.0f, -2.0f);
  half.base_color.w = 1.0f;
  add_ball(without, half, glm::vec3(0.0f), 1.0f, 32);
  add_sheet(without, unlit(0.5f), 9.0f, -2.0f);
  const Estimate whole = trace(integrator_of(without, nullptr), down_z, 4000);
  EXPECT_TRUE(agrees(trace(integrator_of(with, nullptr), down_z, 20000),
                     0.4 * whole.mean + 0.6 * glm::dvec3(0.5), 0.4 * 5.0 * whole.error.x));
  // A mask's hole: nothing of the body is in the way, its far side neither.
  with.materials[0].alpha_mode = scene::AlphaMode::mask;
  EXPECT_EQ(trace(integrator_of(with, nullptr), down_z, 100).mean, glm::dvec3(0.5));
}

TEST(truth_bodies, a_sheet_with_a_thickness_is_a_plate) {
  scene::Material pane = glass(0.0f);
  pane.thickness = 0.5f;
  pane.attenuation_color = {0.25f, 0.5f, 1.0f};
  pane.attenuation_distance = 0.5f;
  scene::Scene scene, box;
  add_sheet(scene, pane, 30.0f, 0.0f);
  add_box(box, pane, {0.0f, 0.0f, -0.25f}, {30.0f, 30.0f, 0.25f});
  const EnvironmentLight light = half_white();
  for (const double angle : {0.0, 40.0, 75.0}) {
    const Ray ray = towards_origin(degrees(angle));
    const Estimate expected = trace(integrator_of(box, &light), ray, 2000);
    EXPECT_TRUE(agrees(trace(integrator_of(scene, &light), ray, 2000), expected.mean,
                       5.0 * expected.error.x + rounding))
        << angle;
  }
}

} // namespace
