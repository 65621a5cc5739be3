// What is needed for what: the pure function, without a device.
#include "core/files.h"
#include "frame/declare.h"
#include "needs/needs.h"
#include "render/shapes.h"
#include "scene/load.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace gg::test {
namespace {

using needs::Feature;
using needs::Method;
using needs::Needs;
using needs::View;

using Labels = std::vector<std::string>;

const Labels deferred_with_neighbours = {"geometry",        "opaque",          "neighbour corners",
                                         "neighbour light", "neighbour cells", "material depth",
                                         "deferred"};

View view(Method method = Method::lobes2) {
  return {.camera = camera_at({0, 0, 6}),
          .width = 64,
          .height = 64,
          .samples = 1,
          .method = method,
          .environment = 0};
}

// The levels of a pyramid count once, and all passes over the solids of a layer.
Labels labels(const Needs& needs) {
  Labels all;
  for (const frame::Pass& pass : frame::graph_of(needs).passes) {
    const std::string label = pass.label.starts_with("glass ") ? "glass" : pass.label;
    const bool counts_once = label == "pyramid" || label == "glass";
    if (!counts_once || all.back() != label) all.push_back(label);
  }
  return all;
}

// None: nothing draws into such a target.
std::optional<frame::Target> target(const Needs& needs, const char* name) {
  const frame::Graph graph = frame::graph_of(needs);
  const frame::Target* found = graph.find(name);
  return found ? std::optional(*found) : std::nullopt;
}

bool has_table(const Needs& needs, const std::string& stem) {
  return std::ranges::any_of(needs.tables,
                             [&](const needs::Table& t) { return t.file.starts_with(stem); });
}

glm::mat4 at(const glm::vec3& place) {
  return glm::translate(glm::mat4(1.0f), place);
}

scene::Material thin(scene::Material material) {
  material.thickness = 0.0f;
  return material;
}

// With an image of one pixel for `slot` of the first material.
scene::Scene with_map(scene::Scene scene, scene::Slot scene::Material::*slot) {
  (scene.materials[0].*slot).texture = 0;
  scene.images = {std::make_shared<image::Image8>(
      image::Image8{.width = 1, .height = 1, .rgba = {9, 9, 9, 9}})};
  scene.textures = {{.image = 0}};
  return scene;
}

scene::Scene square_with_map(const scene::Material& material, scene::Slot scene::Material::*slot) {
  return with_map(square(material), slot);
}

} // namespace

TEST(needs, an_opaque_scene_has_one_pass) {
  const scene::Scene scene = box(dielectric(0.5f));
  const Needs needs = needs::needs_of(scene, view());
  EXPECT_EQ(labels(needs), Labels{"opaque"});
  EXPECT_EQ(frame::graph_of(needs).targets.size(), 2u);
  EXPECT_FALSE(has_table(needs, "interface"));
  EXPECT_EQ(needs.lookups.refracted, 0);
}

TEST(needs, shadow_maps_are_where_a_light_and_what_casts_and_what_is_lit_are) {
  const auto views = [](const scene::Scene& scene, Method method = Method::lobes2) {
    return needs::needs_of(scene, view(method)).shadows.views.size();
  };
  scene::Scene scene = ball(dielectric(0.5f));
  add(scene, square(dielectric(0.5f)), at({0, 0, -1.5f}));
  EXPECT_EQ(views(scene), 0u) << "no light";
  const Needs dark = needs::needs_of(scene, view());
  EXPECT_EQ(labels(dark), deferred_with_neighbours);
  scene.lights = {{.kind = scene::LightKind::directional}, {.position = {0.2f, 0.0f, 4.0f}}};
  EXPECT_EQ(views(scene), 2u);
  EXPECT_EQ(views(scene, Method::standard), 2u);
  const Needs lit = needs::needs_of(scene, view());
  Labels shadowed = deferred_with_neighbours;
  shadowed.insert(shadowed.begin(), 2, "shadow");
  EXPECT_EQ(labels(lit), shadowed);
  EXPECT_FALSE(target(lit, "shadow tint"));
  add(scene, box(thin(glass(0.3f))), at({3.0f, 0.0f, 0.0f}));
  const Needs tinted = needs::needs_of(scene, view());
  EXPECT_TRUE(target(tinted, "shadow tint"));
  EXPECT_EQ(value_of(tinted.draws.all.front().key, Feature::lights), 3);
  scene::Scene alone = ball(dielectric(0.5f));
  alone.lights = scene.lights;
  EXPECT_EQ(views(alone), 0u) << "a convex thing alone";
}

TEST(needs, an_unlit_scene_reads_no_table) {
  EXPECT_TRUE(needs::needs_of(ball(unlit(glm::vec3(1.0f))), view()).tables.empty());
}

TEST(needs, a_wall_without_inside_has_no_interior) {
  const scene::Scene scene = square(thin(glass(0.3f)));
  const Needs needs = needs::needs_of(scene, view());
  EXPECT_EQ(labels(needs), (Labels{"opaque", "scene copy", "pyramid", "refractive"}));
  EXPECT_FALSE(target(needs, "interior"));
}

TEST(needs, a_convex_solid_takes_one_pair_of_faces_and_others_two) {
  const scene::Scene scene = box(glass(0.3f));
  const Needs convex = needs::needs_of(scene, view());
  EXPECT_EQ(labels(convex),
            (Labels{"opaque", "scene copy", "pyramid", "interior F1", "interior B1", "glass"}));
  EXPECT_EQ(target(convex, "interior")->layers, 2);

  scene::Scene head = scene::load(home_directory() / "assets/scenes/Suzanne/Suzanne.gltf");
  head.materials[0] = glass(0.3f);
  const Needs concave = needs::needs_of(head, view());
  EXPECT_EQ(labels(concave), (Labels{"opaque", "scene copy", "pyramid", "interior F1",
                                     "interior B1", "interior F2", "interior B2", "glass"}));
  EXPECT_EQ(target(concave, "interior")->layers, 4);
}

// Half of what scatters diffusely inside a rough body comes from behind the viewer.
TEST(needs, residual_energy_takes_two_lookups_where_it_scatters_inside) {
  const auto residual = [](scene::Scene scene, float roughness) {
    scene.materials[0] = glass(roughness);
    return needs::needs_of(scene, view()).lookups.residual;
  };
  const scene::Scene convex = box(glass(0.3f));
  const scene::Scene head = scene::load(home_directory() / "assets/scenes/Suzanne/Suzanne.gltf");
  EXPECT_EQ(residual(convex, 0.3f), 1);
  EXPECT_EQ(residual(head, 0.3f), 2);
  EXPECT_EQ(residual(head, 0.0f), 1);
}

TEST(needs, index_one_takes_no_tables_and_an_inside_only_where_it_absorbs) {
  scene::Material clear = glass(0.3f, 1.0f);
  EXPECT_EQ(labels(needs::needs_of(ball(clear), view())), Labels{"opaque"}) << "cannot be seen";

  clear.base_color = glm::vec4(0.5f, 1.0f, 1.0f, 1.0f);
  const scene::Scene tinted_ball = ball(clear);
  const Needs tinted = needs::needs_of(tinted_ball, view());
  EXPECT_EQ(labels(tinted), (Labels{"opaque", "scene copy", "refractive"}));
  EXPECT_TRUE(tinted.tables.empty());
  EXPECT_EQ(target(tinted, "screen pyramid")->levels, 1);

  clear.attenuation_color = glm::vec3(0.5f);
  clear.attenuation_distance = 1.0f;
  const scene::Scene dark_ball = ball(clear);
  const Needs dark = needs::needs_of(dark_ball, view());
  EXPECT_EQ(labels(dark),
            (Labels{"opaque", "scene copy", "interior F1", "interior B1", "refractive"}));
  EXPECT_TRUE(dark.tables.empty());
}

TEST(needs, the_standard_method_takes_no_inside_and_no_tables_of_transmission) {
  const scene::Scene scene = box(glass(0.3f));
  const Needs needs = needs::needs_of(scene, view(Method::standard));
  EXPECT_EQ(labels(needs), (Labels{"opaque", "scene copy", "pyramid", "refractive"}));
  EXPECT_FALSE(has_table(needs, "interface"));
  EXPECT_EQ(needs.lookups.refracted, 1);
}

TEST(needs, lobes_are_those_of_the_method) {
  const scene::Scene scene = box(glass(0.3f));
  EXPECT_TRUE(has_table(needs::needs_of(scene, view(Method::lobes1)), "interface-lobes1-ggx"));
  EXPECT_TRUE(has_table(needs::needs_of(scene, view(Method::lobes2)), "interface-lobes2-ggx"));
  EXPECT_EQ(needs::needs_of(scene, view(Method::lobes1)).lookups.refracted, 1);
  EXPECT_EQ(needs::needs_of(scene, view(Method::lobes2)).lookups.refracted, 2);
}

TEST(needs, what_scatters_nothing_reads_no_table_and_takes_one_lobe) {
  scene::Scene scene = box(glass(0.0f));
  add(scene, ball(metal(0.0f)), at({2.5f, 0, 0}));
  add(scene, square(thin(glass(0.0f))), at({-2.5f, 0, 0}));
  const Needs smooth = needs::needs_of(scene, view());
  EXPECT_TRUE(smooth.tables.empty());
  for (const needs::Draw& draw : smooth.draws.all)
    EXPECT_EQ(value_of(draw.key, needs::Feature::lobe_count), 1);
  // One face that scatters is enough.
  scene.materials[0].back_alpha = 0.2f;
  EXPECT_TRUE(has_table(needs::needs_of(scene, view()), "interface-lobes2-ggx"));
}

TEST(needs, thin_walls_read_tables_of_both_faces_and_none_of_one) {
  const scene::Scene scene = square(thin(glass(0.3f)));
  const Needs needs = needs::needs_of(scene, view(Method::lobes2));
  EXPECT_TRUE(has_table(needs, "thin-wall-energy-ggx"));
  EXPECT_TRUE(has_table(needs, "thin-wall-lobes2-ggx"));
  EXPECT_FALSE(has_table(needs, "interface"));
  EXPECT_FALSE(has_table(needs::needs_of(scene, view(Method::standard)), "thin-wall"));
  EXPECT_FALSE(has_table(needs::needs_of(box(glass(0.3f)), view(Method::lobes2)), "thin-wall"));
}

TEST(needs, glass_behind_glass_takes_two_layers_the_farther_one_first) {
  scene::Scene scene = ball(glass(0.1f));
  add(scene, ball(glass(0.1f)), at({0.5f, 0, -3}));
  const Needs needs = needs::needs_of(scene, view());
  ASSERT_EQ(needs.layers.size(), 2u);
  EXPECT_GT(needs.layers[0].regions[0].draws[0]->distance,
            needs.layers[1].regions[0].draws[0]->distance);
  EXPECT_EQ(std::ranges::count(labels(needs), "glass"), 2);
}

// A ball makes an image near itself, a plate shows what is behind it where that is.
TEST(needs, depth_is_copied_again_behind_what_makes_images) {
  const auto depths_taken = [](scene::Scene scene) {
    add(scene, box(glass(0.3f)), at({0, 0, 3}));
    const Needs needs = needs::needs_of(scene, view());
    EXPECT_EQ(needs.layers.size(), 2u);
    const frame::Graph graph = frame::graph_of(needs);
    return std::ranges::count_if(graph.passes, [&](const frame::Pass& pass) {
      return std::ranges::any_of(pass.colors, [&](const frame::ColorOutput& color) {
        return name_of(graph, color.part) == "scene copy depth";
      });
    });
  };
  EXPECT_EQ(depths_taken(ball(glass(0.1f))), 2);
  EXPECT_EQ(depths_taken(box(glass(0.1f))), 1);
  scene::Scene in_contact = ball(glass(0.1f));
  in_contact.instances[0].world = at({0, 0, 1.5f}); // half of it in the box
  EXPECT_EQ(depths_taken(in_contact), 1);
}

TEST(needs, what_lies_within_glass_is_looked_for_there) {
  scene::Scene scene = ball(glass(0.1f));
  add(scene, ball(glass(0.1f)), glm::scale(glm::mat4(1.0f), glm::vec3(0.4f)));
  const Needs needs = needs::needs_of(scene, view());
  EXPECT_NE(value_of(needs.draws.all[0].key, Feature::holds_opaque), 0);
  EXPECT_EQ(value_of(needs.draws.all[1].key, Feature::holds_opaque), 0);
}

TEST(needs, glass_beside_glass_takes_one_layer) {
  scene::Scene scene = ball(glass(0.1f));
  scene.instances[0].world = at({-1.5f, 0, 0});
  add(scene, ball(glass(0.1f)), at({1.5f, 0, 0}));
  EXPECT_EQ(needs::needs_of(scene, view()).layers.size(), 1u);
}

// Their boxes overlap on the screen, they do not.
TEST(needs, balls_that_only_their_boxes_would_overlap_take_one_layer) {
  const auto layers = [](const glm::vec3& second) {
    scene::Scene scene = ball(glass(0.1f));
    scene.instances[0].world = at({-0.8f, -0.8f, 0});
    add(scene, ball(glass(0.1f)), at(second));
    return needs::needs_of(scene, view()).layers.size();
  };
  EXPECT_EQ(layers({0.8f, 0.8f, -0.5f}), 1u);
  EXPECT_EQ(layers({0.4f, 0.4f, -0.5f}), 2u);
}

TEST(needs, a_thin_wall_with_two_sides_is_two_things) {
  scene::Material wall = thin(glass(0.1f));
  wall.double_sided = true;
  const scene::Scene scene = ball(wall);
  const Needs needs = needs::needs_of(scene, view());
  ASSERT_EQ(needs.layers.size(), 2u);
  EXPECT_EQ(needs.layers[0].refractive[0].faces, needs::Faces::back);
  EXPECT_EQ(needs.layers[1].refractive[0].faces, needs::Faces::front);
}

TEST(needs, of_a_planar_wall_with_two_sides_one_is_seen) {
  scene::Material wall = thin(glass(0.1f));
  wall.double_sided = true;
  scene::Scene scene = square(wall);
  scene.instances[0].world = glm::rotate(glm::mat4(1.0f), 0.5f, glm::vec3(1, 2, 3));
  for (int i = 1; i < 20; ++i)
    add(scene, square(wall), at({0, 0, -0.1f * static_cast<float>(i)}));
  const Needs needs = needs::needs_of(scene, view());
  EXPECT_EQ(needs.layers.size(), 20u);
  for (const needs::Layer& layer : needs.layers)
    EXPECT_EQ(layer.refractive.at(0).faces, needs::Faces::as_material);
}

// The first layer of the inside is what is seen, unless a map or `standard` asks for the mesh itself.
// glTF's metallic factor is 1 unless a file says otherwise, and a map scales it: Khronos' TransmissionRoughnessTest is such glass.
TEST(needs, glass_whose_map_takes_the_metal_away_is_refractive) {
  scene::Material m = glass(0.3f);
  m.metallic = 1.0f;
  EXPECT_FALSE(needs::is_refractive(m));
  m.metallic_roughness_map.texture = 0;
  EXPECT_TRUE(needs::is_refractive(m));

  const scene::Scene khronos =
      scene::load(home_directory() / "assets/scenes/TransmissionRoughnessTest.glb");
  const Needs needs = needs::needs_of(khronos, view());
  EXPECT_EQ(std::ranges::count_if(
                needs.draws.all,
                [](const needs::Draw& draw) { return draw.role == needs::Role::refractive; }),
            5);
}

TEST(needs, a_solid_is_drawn_by_its_pixels_where_the_mesh_has_no_more_to_say) {
  scene::Scene scene = ball(glass(0.1f));
  const Needs plain = needs::needs_of(scene, view());
  EXPECT_EQ(plain.layers[0].regions.size(), 1u);
  EXPECT_TRUE(plain.layers[0].refractive.empty());

  const Needs standard = needs::needs_of(scene, view(Method::standard));
  EXPECT_TRUE(standard.layers[0].regions.empty());
  EXPECT_EQ(standard.layers[0].refractive.size(), 1u);

  scene.materials[0].alpha_mode = scene::AlphaMode::mask;
  const Needs masked = needs::needs_of(scene, view());
  EXPECT_TRUE(masked.layers[0].regions.empty());
  EXPECT_EQ(masked.layers[0].refractive.size(), 1u);
}

// Of what is shaded by its triangles the depth test knows.
// Its tangents are what says along which way (the path tracer needs them too); the layer of a region has none.
TEST(needs, glass_is_brushed_where_it_has_tangents) {
  scene::Material brushed = glass(0.1f);
  brushed.anisotropy_strength = 0.5f;
  scene::Scene scene = ball(brushed);
  const auto drawn = [&] { return needs::needs_of(scene, view()).draws.all[0]; };
  EXPECT_EQ(value_of(drawn().key, Feature::anisotropy), 1);
  EXPECT_FALSE(drawn().by_pixel);
  scene.meshes[0].primitives[0].tangents = scene::none;
  EXPECT_EQ(value_of(drawn().key, Feature::anisotropy), 0);
  EXPECT_TRUE(drawn().by_pixel);
}

TEST(needs, the_depth_of_glass_is_taken_where_it_may_hide_parts_of_a_solid_drawn_later) {
  const auto taken = [](float z, scene::Material material) {
    scene::Scene scene = box(glass(0.1f)); // flat faces: what lookups meet is not copied again
    scene.instances[0].world = at({0.9f, 0, z});
    add(scene, ball(material), at({-0.9f, 0, 0}));
    const Needs needs = needs::needs_of(scene, view());
    EXPECT_EQ(needs.layers.size(), 2u);
    return target(needs, "glass depth").has_value();
  };
  EXPECT_TRUE(taken(-0.5f, glass(0.1f))); // the box lies farther, its front before the ball's back
  EXPECT_FALSE(taken(-3.0f, glass(0.1f)));
  scene::Material masked = glass(0.1f);
  masked.alpha_mode = scene::AlphaMode::mask;
  EXPECT_FALSE(taken(-0.5f, masked));
}

TEST(needs, back_faces_of_a_closed_solid_are_seen_only_where_the_near_plane_cuts_it) {
  const auto seen_from_within = [](bool double_sided, float distance) {
    scene::Scene scene = box(glass(0.1f));
    scene.materials[0].double_sided = double_sided;
    needs::View near = view();
    near.camera = camera_at({0, 0, distance});
    near.camera.near = 0.01f;
    const Needs needs = needs::needs_of(scene, near);
    return value_of(needs.draws.all[0].key, needs::Feature::seen_from_within) != 0;
  };
  EXPECT_FALSE(seen_from_within(false, 3.0f));
  EXPECT_FALSE(seen_from_within(true, 3.0f));
  EXPECT_TRUE(seen_from_within(false, 0.2f));
  EXPECT_TRUE(seen_from_within(false, 1.005f)) << "outside, but nearer than the near plane";
}

TEST(needs, walls_are_opaque_rectangles_without_holes_the_largest_first) {
  scene::Scene scene = square(unlit(glm::vec3(1.0f)));
  add(scene, square(unlit(glm::vec3(1.0f))),
      glm::scale(glm::rotate(at({0, -1, 0}), 1.2f, glm::vec3(1, 0.3f, 0)), glm::vec3(2, 3, 1)));
  add(scene, ball(metal(0.1f)), at({1.5f, 0, 0}));
  add(scene, square(thin(glass(0.1f))), at({-1.5f, 0, 0}));
  scene::Material holes = unlit(glm::vec3(1.0f));
  holes.alpha_mode = scene::AlphaMode::mask;
  add(scene, square(holes), at({0, 1.5f, 0}));
  const Needs needs = needs::needs_of(scene, view());
  ASSERT_EQ(needs.walls.size(), 2u);
  EXPECT_NEAR(needs.walls[0].area, 24.0f, 1e-4f);
  EXPECT_NEAR(needs.walls[1].area, 4.0f, 1e-5f);
  // Its gradients count to 1 at its edges, wherever it stands.
  const glm::mat4 placed = scene.instances[1].world;
  const needs::Wall& wall = needs.walls[0];
  for (const glm::vec2 edge : {glm::vec2(1, 0.5f), glm::vec2(-0.25f, 1)}) {
    const glm::vec3 off = glm::vec3(placed * glm::vec4(edge, 0, 1)) - wall.centre;
    EXPECT_NEAR(std::abs(glm::dot(off, wall.gradient_u)), std::abs(edge.x), 1e-5f);
    EXPECT_NEAR(std::abs(glm::dot(off, wall.gradient_v)), std::abs(edge.y), 1e-5f);
  }
  EXPECT_TRUE(needs::needs_of(scene, view(Method::standard)).walls.empty());
}

TEST(needs, what_stands_before_glass_is_its_foreground_and_what_stands_behind_is_not) {
  scene::Scene scene = ball(glass(0.1f));
  add(scene, square(unlit(glm::vec3(1.0f))), at({0.5f, 0, 2}));
  add(scene, square(unlit(glm::vec3(1.0f))), at({0.5f, 0, -2}));
  const Needs needs = needs::needs_of(scene, view());
  ASSERT_EQ(needs.layers.size(), 1u);
  ASSERT_EQ(needs.layers[0].foreground.size(), 1u);
  EXPECT_EQ(needs.layers[0].foreground[0]->bounds.low.z, 2.0f);
}

TEST(needs, blended_surfaces_without_glass_behind_them_take_no_pass) {
  scene::Material veil = dielectric(0.9f);
  veil.alpha_mode = scene::AlphaMode::blend;
  scene::Scene scene = box(dielectric(0.9f));
  add(scene, square(veil), at({0, 0, 2}));
  const Needs needs = needs::needs_of(scene, view());
  EXPECT_EQ(labels(needs), Labels{"opaque"});
  EXPECT_EQ(needs.over_opaque.size(), 1u);
}

// 36,480 triangles.
TEST(needs, a_fine_mesh_is_shaded_by_its_pixels_and_a_coarse_one_by_its_triangles) {
  const scene::Scene scene = ball(dielectric(0.5f));
  const Needs small = needs::needs_of(scene, view());
  EXPECT_EQ(labels(small), (Labels{"geometry", "opaque", "material depth", "deferred"}));
  EXPECT_TRUE(small.opaque.empty());
  ASSERT_EQ(small.opaque_regions.size(), 1u);
  EXPECT_TRUE(target(small, "geometry"));

  // The ball's box is 2.4 of 5 high: 16 pixels per triangle are passed at about 1,600 high.
  needs::View large = view();
  large.width = large.height = 1200;
  EXPECT_FALSE(needs::needs_of(scene, large).opaque_regions.empty());
  large.width = large.height = 2400;
  const Needs coarse = needs::needs_of(scene, large);
  EXPECT_EQ(labels(coarse), Labels{"opaque"});
  EXPECT_FALSE(target(coarse, "geometry"));
}

// Depth and normal are all that is kept of the mesh, and without light there is nothing to save.
TEST(needs, what_takes_more_from_its_mesh_is_shaded_by_its_triangles) {
  scene::Material masked = metal(0.2f), veil = metal(0.2f);
  masked.alpha_mode = scene::AlphaMode::mask;
  veil.alpha_mode = scene::AlphaMode::blend;
  scene::Scene colored = ball(metal(0.2f)), mapped = ball(dielectric(0.5f));
  colored.meshes[0].primitives[0].colors = colored.meshes[0].primitives[0].tangents;
  mapped.images = {std::make_shared<image::Image8>(
      image::Image8{.width = 1, .height = 1, .rgba = {9, 9, 9, 9}})};
  mapped.textures = {{.image = 0}};
  scene::Scene kept = mapped;
  mapped.materials[0].specular_map.texture = 0;
  kept.materials[0].metallic_roughness_map.texture = 0;
  for (const scene::Scene& scene : {ball(masked), ball(veil), ball(unlit(glm::vec3(1.0f))), mapped})
    EXPECT_EQ(labels(needs::needs_of(scene, view())), Labels{"opaque"});
  for (const scene::Scene& scene : {colored, kept}) {
    const Needs needs = needs::needs_of(scene, view());
    EXPECT_EQ(labels(needs), (Labels{"geometry", "opaque", "material depth", "deferred"}));
    EXPECT_NE(frame::graph_of(needs).find("geometry maps"), nullptr);
  }
}

// Its maps hold no metal, but for that of the opaque balls; the one of IOR 1 bends nothing.
TEST(needs, glass_whose_roughness_a_map_says_takes_deferred_shading) {
  const scene::Scene scene =
      scene::load(home_directory() / "assets/scenes/TransmissionRoughnessTest.glb");
  for (const scene::Material& material : scene.materials)
    if (material.name.starts_with("Mat_")) {
      EXPECT_EQ(material.metallic, material.name == "Mat_Opaque" ? 1.0f : 0.0f) << material.name;
    }
  const Needs needs = needs::needs_of(scene, view());
  EXPECT_EQ(std::ranges::count_if(needs.draws.all,
                                  [](const needs::Draw& draw) {
                                    return draw.role == needs::Role::refractive && draw.by_pixel;
                                  }),
            4);
}

// A box has few triangles. Importance sampling is noise, a coat has lobes of its own.
TEST(needs, what_neighbours_add_is_interpolated_where_a_fitted_lobe_meets_some) {
  scene::Scene scene = box(dielectric(0.5f));
  const auto interpolates = [&](Method method, const needs::FeatureSet& without = {}) {
    needs::View asked = view(method);
    asked.without = without;
    const Needs needs = needs::needs_of(scene, asked);
    return target(needs, "neighbour cells").has_value() && needs.opaque.empty();
  };
  EXPECT_FALSE(interpolates(Method::lobes2)) << "alone";
  add(scene, box(metal(0.2f)), at({0, 2, 0}));
  EXPECT_TRUE(interpolates(Method::lobes2));
  EXPECT_TRUE(interpolates(Method::lobes1));
  EXPECT_FALSE(interpolates(Method::standard));
  EXPECT_FALSE(interpolates(needs::fis(4)));
  needs::FeatureSet without;
  without.set(static_cast<std::size_t>(Feature::interpolated_neighbours));
  EXPECT_FALSE(interpolates(Method::lobes2, without));
  for (scene::Material& material : scene.materials)
    material.clearcoat = 1.0f;
  EXPECT_FALSE(interpolates(Method::lobes2));
}

TEST(needs, fine_meshes_of_one_material_and_the_same_neighbours_share_a_region) {
  const scene::Scene one = ball(metal(0.2f));
  scene::Scene scene = one;
  scene.instances.push_back({.mesh = 0, .name = "again"});
  scene.instances.back().world = at({1.5f, 0, 0});
  add(scene, ball(dielectric(0.9f)), at({-1.5f, 0, 0}));
  add(scene, box(metal(0.2f)), at({0, 2, 0}));
  const Needs needs = needs::needs_of(scene, view());
  EXPECT_EQ(labels(needs), deferred_with_neighbours);
  EXPECT_EQ(needs.opaque_regions.size(), 4u) << "each has the others around it";
  scene.instances[1].world = at({0, 0, -300.0f}); // no neighbour of the others, nor they of it
  scene.instances[0].world = at({0, 0, -100.0f});
  scene.instances[2].world = scene.instances[3].world = at({0, 300.0f, 0});
  const Needs apart = needs::needs_of(scene, view());
  ASSERT_EQ(apart.opaque_regions.size(), 1u);
  EXPECT_EQ(apart.opaque_regions[0].draws.size(), 2u);
}

TEST(needs, a_map_that_cannot_matter_is_not_uploaded) {
  scene::Material shiny = dielectric(0.0f); // scales a roughness and a metalness of 0
  const auto maps = [](const scene::Scene& scene) {
    return needs::needs_of(scene, view()).images.size();
  };
  EXPECT_EQ(maps(square_with_map(shiny, &scene::Material::metallic_roughness_map)), 0u);
  EXPECT_EQ(maps(square_with_map(dielectric(0.5f), &scene::Material::metallic_roughness_map)), 1u);
  EXPECT_EQ(maps(square_with_map(dielectric(0.5f), &scene::Material::emissive_map)), 0u);
  EXPECT_EQ(maps(square_with_map(dielectric(0.5f), &scene::Material::thickness_map)), 0u);
  EXPECT_EQ(maps(square_with_map(unlit(glm::vec3(1)), &scene::Material::occlusion_map)), 0u);
  EXPECT_EQ(maps(square_with_map(unlit(glm::vec3(1)), &scene::Material::base_color_map)), 1u);
}

// The search within finds the far side of a closed solid; an open one is a plate as thick as the map says.
TEST(needs, a_thickness_map_is_for_what_has_no_far_side) {
  scene::Scene solid = ball(glass(0.1f));
  solid.meshes[0].primitives[0].uvs[0] = solid.meshes[0].primitives[0].normals;
  solid = with_map(solid, &scene::Material::thickness_map);
  const Needs closed = needs::needs_of(solid, view());
  EXPECT_TRUE(closed.images.empty());
  EXPECT_TRUE(closed.draws.all[0].by_pixel);
  EXPECT_EQ(closed.draws.all[0].inputs.size(), 2u) << "positions and normals";
  EXPECT_EQ(needs::needs_of(solid, view(Method::standard)).images.size(), 1u);
  const scene::Scene plate = square_with_map(glass(0.1f), &scene::Material::thickness_map);
  EXPECT_EQ(needs::needs_of(plate, view()).images.size(), 1u);
}

TEST(needs, a_map_on_a_fifth_set_of_coordinates_is_named) {
  scene::Scene scene = square_with_map(dielectric(0.5f), &scene::Material::base_color_map);
  scene::Material& m = scene.materials[0];
  m.name.clear();
  m.emissive = glm::vec3(1.0f);
  m.metallic = 0.5f;
  scene.meshes[0].primitives[0].uvs.resize(5, scene.meshes[0].primitives[0].uvs[0]);
  int set = 0;
  for (scene::Slot* const slot : {&m.base_color_map, &m.metallic_roughness_map, &m.occlusion_map,
                                  &m.specular_map, &m.emissive_map})
    *slot = {.texture = 0, .uv_set = set++};
  testing::internal::CaptureStderr();
  EXPECT_EQ(needs::needs_of(scene, view()).draws.all[0].maps.size(), 4u);
  const std::string said = testing::internal::GetCapturedStderr();
  EXPECT_NE(said.find("materials[0] reads more than 4"), std::string::npos) << said;
  EXPECT_NE(said.find("TEXCOORD_"), std::string::npos) << said;
}

TEST(needs, every_table_that_is_listed_is_there) {
  scene::Scene scene = box(glass(0.3f));
  for (const Method method : {Method::standard, Method::lobes1, Method::lobes2})
    for (const needs::Table& table : needs::needs_of(scene, view(method)).tables)
      EXPECT_TRUE(std::filesystem::exists(home_directory() / "assets/tables" / table.file))
          << table.file;
}

} // namespace gg::test
