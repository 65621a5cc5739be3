// What a material and its maps do to a surface, and which surfaces are seen.
#include "needs/view.h"
#include "render/head_on.h"
#include "support/pictures.h"

#include <glm/gtc/matrix_transform.hpp>

#include <cmath>

namespace gg::test::surfaces_test {
namespace {

constexpr int size = head_on_size;
constexpr float rounding = 1e-6f;
constexpr float eight_bits = 0.5f / 255.0f;

glm::vec3 centre(const image::Image& p) {
  return rgb(p, size / 2, size / 2);
}

void expect_color(glm::vec3 color, glm::vec3 expected, float tolerance, const char* what) {
  for (int c = 0; c < 3; ++c)
    EXPECT_NEAR(color[c], expected[c], tolerance) << what << ", channel " << c;
}

// A texture of width x height texels given as sRGB bytes, row 0 first.
scene::Slot add_texture(scene::Scene& scene, int width, int height,
                        std::vector<std::uint8_t> rgba) {
  scene.images.push_back(
      std::make_shared<image::Image8>(image::Image8{width, height, std::move(rgba)}));
  scene::Texture texture;
  texture.image = static_cast<scene::Index>(scene.images.size()) - 1;
  texture.sampler.magnify = scene::Filter::nearest;
  texture.sampler.mipmaps = false;
  scene.textures.push_back(texture);
  scene::Slot slot;
  slot.texture = static_cast<scene::Index>(scene.textures.size()) - 1;
  return slot;
}

// Upper left red, upper right green, lower left blue, lower right white but transparent.
scene::Slot four_colors(scene::Scene& scene) {
  return add_texture(scene, 2, 2,
                     {255, 0, 0, 255, 0, 255, 0, 255, 0, 0, 255, 255, 255, 255, 255, 0});
}

constexpr int near_edge =
    8; // a pixel this far from a corner lies on the square (which fills 0.83 of the picture)

const glm::vec3 red(1, 0, 0), green(0, 1, 0), blue(0, 0, 1), white(1), black(0);

} // namespace

TEST_P(Render, unlit_surface_shows_its_color_exactly) {
  expect_color(centre(draw(square(unlit({0.25f, 0.5f, 2.0f})),
                           {environment::constant(glm::vec3(1)), head_on()})),
               {0.25f, 0.5f, 2.0f}, rounding, "unlit");
}

TEST_P(Render, nearer_surface_hides_the_farther_one_in_any_order) {
  const glm::mat4 back = glm::translate(glm::mat4(1), glm::vec3(0, 0, -0.01f));
  scene::Scene near_first = square(unlit(red)), far_first = square(unlit(green));
  add(near_first, square(unlit(green)), back);
  far_first.instances[0].world = back;
  add(far_first, square(unlit(red)), glm::mat4(1));
  expect_color(centre(draw(near_first, {std::nullopt, head_on()})), red, 0, "near first");
  expect_color(centre(draw(far_first, {std::nullopt, head_on()})), red, 0, "far first");
}

TEST_P(Render, texture_lies_the_right_way_up) {
  scene::Scene scene = square(unlit(white));
  scene.materials[0].base_color_map = four_colors(scene);
  const image::Image p = draw(scene, {std::nullopt, head_on()});
  expect_color(rgb(p, near_edge, near_edge), red, rounding, "upper left");
  expect_color(rgb(p, size - near_edge, near_edge), green, rounding, "upper right");
  expect_color(rgb(p, near_edge, size - near_edge), blue, rounding, "lower left");
}

TEST_P(Render, texture_transform_moves_the_coordinates) {
  scene::Scene scene = square(unlit(white));
  scene::Slot slot = four_colors(scene);
  slot.transform = glm::mat3(glm::vec3(1, 0, 0), glm::vec3(0, 1, 0),
                             glm::vec3(0.5f, 0, 1)); // half a picture to the left
  scene.materials[0].base_color_map = slot;
  const image::Image p = draw(scene, {std::nullopt, head_on()});
  expect_color(rgb(p, near_edge, near_edge), green, rounding, "upper left");
  expect_color(rgb(p, size - near_edge, near_edge), red, rounding, "upper right, repeated");
}

TEST_P(Render, a_map_reads_the_set_of_coordinates_that_it_names) {
  scene::Scene scene = square(unlit(white));
  scene::Primitive& p = scene.meshes[0].primitives[0];
  scene.streams.push_back(
      {2, {0.9f, 0.1f, 0.9f, 0.1f, 0.9f, 0.1f, 0.9f, 0.1f}}); // all of it in the upper right texel
  p.uvs.push_back(static_cast<scene::Index>(scene.streams.size()) - 1);
  scene::Slot slot = four_colors(scene);
  slot.uv_set = 1;
  scene.materials[0].base_color_map = slot;
  const image::Image picture = draw(scene, {std::nullopt, head_on()});
  expect_color(rgb(picture, near_edge, near_edge), green, rounding, "upper left");
  expect_color(rgb(picture, near_edge, size - near_edge), green, rounding, "lower left");
}

// Of a fine mesh maps are read first and shaded by its pixels afterwards; with a map that texels do not keep, by its triangles. Nearest
// texels change within a pixel, where a triangle's edge may fall to either.
TEST_P(Render, maps_say_the_same_by_the_pixels_of_a_fine_mesh_and_by_its_triangles) {
  scene::Scene scene = ball(metal(0.5f));
  scene::Material& m = scene.materials[0];
  m.base_color_map = four_colors(scene);
  m.alpha_mode = scene::AlphaMode::mask;
  m.metallic_roughness_map = add_texture(scene, 2, 1, {0, 250, 255, 255, 0, 90, 40, 255});
  m.occlusion_map = add_texture(scene, 1, 2, {255, 0, 0, 255, 99, 0, 0, 255});
  m.emissive = {0.2f, 0.1f, 0.3f};
  m.specular_color = glm::vec3(0.9f); // Schlick's form, as with the map below
  m.emissive_map = add_texture(scene, 1, 2, {255, 99, 99, 255, 99, 255, 99, 255});
  m.normal_map = add_texture(scene, 1, 1, {150, 128, 250, 255});
  scene::Scene by_triangles = scene;
  by_triangles.materials[0].specular_map = add_texture(by_triangles, 1, 1, {255, 255, 255, 255});
  const Setup setup{environment_of(16, [](glm::dvec3 d) { return 0.5 + 0.4 * d; }), head_on()};
  EXPECT_TRUE(pictures_agree(draw(scene, setup), draw(by_triangles, setup),
                             {.difference = 2.0f * eight_bits, .fraction_over = 0.01}));
}

TEST_P(Render, two_maps_of_one_material_read_two_sets) {
  scene::Scene scene = square(dielectric(1.0f, black));
  scene::Primitive& p = scene.meshes[0].primitives[0];
  scene.streams.push_back({2,
                           {0.1f, 0.9f, 0.1f, 0.9f, 0.1f, 0.9f, 0.1f,
                            0.9f}}); // all of it in the lower left texel: blue
  p.uvs.push_back(static_cast<scene::Index>(scene.streams.size()) - 1);
  scene.materials[0].unlit = true;
  scene.materials[0].base_color = glm::vec4(1.0f);
  scene.materials[0].base_color_map = four_colors(scene);
  const image::Image first = draw(scene, {std::nullopt, head_on()});
  scene.materials[0].unlit = false;
  scene.materials[0].base_color = glm::vec4(0.0f, 0.0f, 0.0f, 1.0f);
  scene.materials[0].emissive = white;
  scene.materials[0].emissive_map = four_colors(scene);
  scene.materials[0].emissive_map.uv_set = 1;
  const image::Image second = draw(scene, {std::nullopt, head_on()});
  expect_color(rgb(first, near_edge, near_edge), red, rounding, "base colour, set 0");
  expect_color(rgb(second, near_edge, near_edge), blue, rounding, "emission, set 1");
  expect_color(rgb(second, size - near_edge, near_edge), blue, rounding, "emission, set 1, right");
}

// Interpolated normals lean away from the viewer at silhouettes. There the surface is seen at grazing, not unlit.
TEST_P(Render, a_normal_that_leans_away_from_the_viewer_leaves_no_black_fringe) {
  scene::Scene scene = square(metal(0.5f));
  std::vector<float>& normals =
      scene.streams[static_cast<std::size_t>(scene.meshes[0].primitives[0].normals)].values;
  for (std::size_t i = 0; i < normals.size(); i += 3)
    normals[i] = 1.0f, normals[i + 1] = 0.0f, normals[i + 2] = -0.2f;
  const glm::vec3 seen = centre(draw(scene, {environment::constant(glm::vec3(1)), head_on()}));
  EXPECT_GT(seen.r, 0.3f); // the grazing albedo at alpha .25 is .6
}

TEST_P(Render, base_color_is_decoded_from_srgb_and_multiplied_with_vertex_color) {
  scene::Scene scene = square(unlit(white));
  scene.materials[0].base_color_map = add_texture(scene, 1, 1, {188, 188, 188, 255});
  scene.streams.push_back(
      {4, {1, 0.5f, 0.25f, 1, 1, 0.5f, 0.25f, 1, 1, 0.5f, 0.25f, 1, 1, 0.5f, 0.25f, 1}});
  scene.meshes[0].primitives[0].colors = static_cast<scene::Index>(scene.streams.size()) - 1;
  const float decoded = std::pow((188.0f / 255.0f + 0.055f) / 1.055f, 2.4f);
  expect_color(centre(draw(scene, {std::nullopt, head_on()})), decoded * glm::vec3(1, 0.5f, 0.25f),
               eight_bits, "grey");
}

TEST_P(Render, masked_texels_are_cut_out_and_blended_ones_let_the_back_through) {
  for (const auto mode :
       {scene::AlphaMode::opaque, scene::AlphaMode::mask, scene::AlphaMode::blend}) {
    scene::Scene scene = square(unlit(white));
    scene.materials[0].alpha_mode = mode;
    scene.materials[0].base_color_map = four_colors(scene);
    add(scene, square(unlit({0, 0.5f, 0.5f})),
        glm::translate(glm::mat4(1), glm::vec3(0, 0, -0.2f)));
    const image::Image p = draw(scene, {std::nullopt, head_on()});
    expect_color(rgb(p, near_edge + 4, near_edge + 4), red, rounding, "solid texel");
    expect_color(rgb(p, size - near_edge - 4, size - near_edge - 4),
                 mode == scene::AlphaMode::opaque ? white : glm::vec3(0, 0.5f, 0.5f), rounding,
                 "transparent texel");
  }
}

TEST_P(Render, half_transparent_layers_are_put_over_each_other_far_to_near) {
  scene::Material glassy = unlit(red);
  glassy.base_color.a = 0.5f;
  glassy.alpha_mode = scene::AlphaMode::blend;
  scene::Scene scene = square(glassy); // nearest, first in the file
  glassy.base_color = {0, 1, 0, 0.5f};
  add(scene, square(glassy), glm::translate(glm::mat4(1), glm::vec3(0, 0, -0.2f)));
  add(scene, square(unlit(blue)), glm::translate(glm::mat4(1), glm::vec3(0, 0, -0.4f)));
  expect_color(centre(draw(scene, {std::nullopt, head_on()})), {0.5f, 0.25f, 0.25f}, rounding,
               "red over green over blue");
}

TEST_P(Render, back_faces_are_seen_only_on_double_sided_materials) {
  frame::FrameDesc from_behind = head_on();
  from_behind.camera = camera_at({0, 0, -2});
  scene::Material m = unlit(red);
  expect_color(centre(draw(square(m), {std::nullopt, from_behind})), black, 0, "single-sided");
  m.double_sided = true;
  expect_color(centre(draw(square(m), {std::nullopt, from_behind})), red, rounding, "double-sided");
}

TEST_P(Render, a_double_sided_square_is_lit_alike_from_both_sides) {
  scene::Material m = dielectric(0.5f);
  m.double_sided = true;
  frame::FrameDesc behind = head_on();
  behind.camera = camera_at({0, 0, -2});
  const auto environment = environment::constant(glm::vec3(1));
  const glm::vec3 front = centre(draw(square(m), {environment, head_on()}));
  expect_color(centre(draw(square(m), {environment, behind})), front, 1e-5f, "from behind");
}

TEST_P(Render, a_mirrored_mesh_looks_like_the_mirrored_picture) {
  scene::Scene scene = square(dielectric(0.4f));
  scene.materials[0].normal_map = add_texture(scene, 2, 1, {200, 160, 220, 255, 90, 140, 230, 255});
  scene.materials[0].base_color_map = four_colors(scene);
  scene.lights.emplace_back();
  scene.lights[0].position = {0, 0.4f, 1}; // in the plane of symmetry
  const image::Image straight = draw(scene, {std::nullopt, head_on()});
  scene.instances[0].world = glm::scale(glm::mat4(1), glm::vec3(-1, 1, 1));
  scene.instances[0].mirrored = true;
  const image::Image mirrored = draw(scene, {std::nullopt, head_on()});
  double worst = 0.0;
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x)
      worst = std::max(worst, glm::length(rgb(mirrored, x, y) - rgb(straight, size - 1 - x, y)));
  EXPECT_LT(worst, 1e-5f);
  EXPECT_GT(centre(straight).r + centre(straight).g + centre(straight).b, 0.01f);
}

TEST_P(Render, normal_map_turns_the_normal_by_its_own_angle) {
  // A map that leans 45 degrees towards +U makes the square look, to a light along that direction,
  // like one facing it.
  scene::Scene scene = square(dielectric(1.0f));
  const auto half =
      static_cast<std::uint8_t>(std::lround((0.5f + 0.5f * std::sqrt(0.5f)) * 255.0f));
  scene.materials[0].normal_map = add_texture(scene, 1, 1, {half, 128, half, 255});
  scene.lights.emplace_back();
  scene.lights[0].kind = scene::LightKind::directional;
  const auto lit_from = [&](glm::vec3 from) {
    scene.lights[0].direction = -glm::normalize(from);
    return centre(draw(scene, {std::nullopt, head_on()})).r;
  };
  const float along = lit_from({1, 0, 1}), head = lit_from({0, 0, 1}), away = lit_from({-1, 0, 1});
  EXPECT_GT(along, head);
  EXPECT_GT(head, 0.0f);
  EXPECT_LT(away, along * 0.02f); // at its horizon, but for what 8 bits round
}

TEST_P(Render, occlusion_darkens_the_environment_and_not_the_lights) {
  scene::Scene scene = square(dielectric(0.7f));
  const image::Image open_sky = draw(scene, {environment::constant(glm::vec3(1)), head_on()});
  scene.lights.emplace_back();
  scene.lights[0].position = {0, 0, 1};
  const image::Image open_light = draw(scene, {std::nullopt, head_on()});
  scene.materials[0].occlusion_map = add_texture(scene, 1, 1, {51, 0, 0, 255}); // 0.2
  scene.materials[0].occlusion_map.scale = 0.5f; // strength: 1 + 0.5 (0.2 - 1) = 0.6
  expect_color(centre(draw(scene, {std::nullopt, head_on()})), centre(open_light), rounding,
               "light");
  scene.lights.clear();
  expect_color(centre(draw(scene, {environment::constant(glm::vec3(1)), head_on()})),
               0.6f * centre(open_sky), 1e-4f, "sky");
}

TEST_P(Render, emission_is_added_to_what_is_reflected) {
  scene::Scene scene = square(dielectric(0.7f));
  const auto sky = environment::constant(glm::vec3(1));
  const glm::vec3 reflected = centre(draw(scene, {sky, head_on()}));
  scene.materials[0].emissive = {5.0f, 0.0f, 1.0f};
  expect_color(centre(draw(scene, {sky, head_on()})), reflected + glm::vec3(5, 0, 1), 1e-5f,
               "emission");
}

TEST_P(Render, same_scene_gives_the_same_bytes) {
  const scene::Scene scene = ball(dielectric(0.3f));
  frame::FrameDesc desc = head_on();
  desc.samples = 4;
  const auto sky = environment_of(64, [](glm::dvec3 d) { return d * d; });
  EXPECT_EQ(draw(scene, {sky, desc}).values, draw(scene, {sky, desc}).values);
}

TEST_P(Render, samples_average_the_pixel_over_its_box) {
  // An edge at x = 0 crosses pixel columns at their border; moved by a third of a pixel it covers a
  // third of one.
  frame::FrameDesc desc = head_on();
  desc.samples = 256;
  const double pixel = 2.0 * 2.0 * std::tan(0.5 * static_cast<double>(desc.camera.fovy))
                       / size; // metres at the square
  scene::Scene scene = square(unlit(white));
  scene.instances[0].world = glm::translate(glm::mat4(1), glm::vec3(-1.0 + pixel / 3.0, 0, 0));
  const image::Image p = draw(scene, {std::nullopt, desc});
  EXPECT_NEAR(p.at(size / 2 - 1, size / 2, 0), 1.0f, 1e-5f);
  EXPECT_NEAR(p.at(size / 2, size / 2, 0), 1.0f / 3.0f,
              1.5f / 256.0f); // quadrature: one sample more or less
  EXPECT_NEAR(p.at(size / 2 + 1, size / 2, 0), 0.0f, 0.0f);
}

// A rough floor reflects the half of a lit board that stands on it, at alpha .25 spread over much of the picture. One sample
// meets the board or not; many meet it by their parts of the lobe: the greatest step is smaller by a third at
// least (beside the board's foot the outline is sharp in truth).
TEST_P(Render, what_a_rough_surface_reflects_of_a_neighbour_has_no_outline_at_one_sample) {
  constexpr int size = 96;
  scene::Scene scene = square(metal(0.5f));
  scene.instances[0].world =
      glm::rotate(glm::scale(glm::mat4(1.0f), glm::vec3(4.0f)), -glm::half_pi<float>(), {1, 0, 0});
  scene.bounds = {};
  scene.bounds.include({-4, 0, -4});
  scene.bounds.include({4, 0, 4});
  add(scene, square(unlit(glm::vec3(1.0f))), glm::translate(glm::mat4(1.0f), {1, 1.2f, -2}));
  const auto greatest_step = [&](int samples) {
    const image::Image picture = draw(scene, {environment::constant(glm::vec3(0.0f)),
                                              {.width = size,
                                               .height = size,
                                               .samples = samples,
                                               .camera = camera_at({0, 1.5f, 5}),
                                               .method = frame::Method::lobes2}});
    float step = 0.0f, most = 0.0f;
    for (int y = 2 * size / 3; y < size; ++y)
      for (int x = 1; x < size; ++x) {
        step = std::max(step, std::abs(picture.at(x, y, 1) - picture.at(x - 1, y, 1)));
        most = std::max(most, picture.at(x, y, 1));
      }
    EXPECT_GT(most, 0.05f) << "the board is not reflected";
    return step / most;
  };
  for (const int samples : {1, 16})
    EXPECT_LT(greatest_step(samples), 0.05f) << "between neighbouring pixels, of the brightest";
}

// Red glass over a floor of polished metal, under a white sky: the floor shows the sky and, where the glass mirrors, red.
TEST_P(Render, metal_shows_the_glass_about_it) {
  constexpr int size = 96;
  scene::Material red = glass(0.3f);
  red.base_color = {1.0f, 0.1f, 0.1f, 1.0f};
  scene::Scene scene = square(metal(0.0f));
  scene.instances[0].world =
      glm::rotate(glm::scale(glm::translate(glm::mat4(1.0f), {0, -0.8f, 0}), glm::vec3(4.0f)),
                  -glm::half_pi<float>(), {1, 0, 0});
  scene.bounds = {};
  scene.bounds.include({-4, -0.8f, -4});
  scene.bounds.include({4, -0.8f, 4});
  const glm::vec3 centre{0, 0.2f, 0}, mirrored{0, -1.8f, 0};
  add(scene, ball(red), glm::scale(glm::translate(glm::mat4(1.0f), centre), glm::vec3(0.5f)));
  const frame::FrameDesc desc{.width = size,
                              .height = size,
                              .samples = 1,
                              .camera = camera_at({0, 1.0f, 5}),
                              .method = frame::Method::lobes2};
  const image::Image picture = draw(scene, {environment::constant(white), desc});
  const glm::dvec4 clip =
      needs::clip_from_world({.camera = desc.camera, .width = size, .height = size})
      * glm::dvec4(mirrored, 1.0);
  const int y = static_cast<int>(0.5 * (1.0 - clip.y / clip.w) * size);
  const glm::vec3 there = rgb(picture, size / 2, y), beside = rgb(picture, size / 8, y);
  EXPECT_LT(there.g, 0.6f * there.r);
  expect_color(beside, white, 0.05f, "the floor beside"); // of the lobe's table at alpha 0
}

// Metal is shaded once more where there is something to reflect: not over what lies before it.
TEST_P(Render, a_veil_stays_over_metal_that_has_neighbours) {
  scene::Material veil = unlit(glm::vec3(0.0f));
  veil.alpha_mode = scene::AlphaMode::blend;
  veil.base_color.a = 0.75f;
  for (const bool with_glass : {false, true}) {
    scene::Scene scene = square(metal(0.5f));
    add(scene, square(veil), glm::translate(glm::mat4(1.0f), {0, 0, 0.5f}));
    add(scene, with_glass ? ball(glass(0.1f)) : ball(dielectric(0.5f)),
        glm::scale(glm::translate(glm::mat4(1.0f), {1.1f, 0, 0.3f}), glm::vec3(0.2f)));
    frame::FrameDesc desc = head_on();
    desc.method = frame::Method::lobes2;
    const glm::vec3 seen = centre(draw(scene, {environment::constant(white), desc}));
    EXPECT_LT(seen.g, 0.26f) << (with_glass ? "beside glass" : "beside plaster");
    EXPECT_GT(seen.g, 0.15f);
  }
}

TEST_P(Render, orthographic_camera_shows_its_half_extents) {
  frame::FrameDesc desc = head_on();
  desc.camera.orthographic = true;
  desc.camera.magnification = glm::vec2(2.0f);
  desc.camera.far = 10.0f;
  const image::Image p = draw(square(unlit(white)), {std::nullopt, desc});
  int lit = 0;
  for (int x = 0; x < size; ++x)
    lit += p.at(x, size / 2, 0) > 0.5f;
  EXPECT_EQ(lit, size / 2); // the square is 2 m wide, the picture 4 m
}

TEST_P(Render, a_material_that_sees_no_light_is_black_and_not_nan) {
  for (const float roughness : {0.0f, 0.5f, 1.0f})
    for (const scene::Material& m : {metal(roughness), dielectric(roughness)}) {
      const image::Image p = draw(ball(m), {std::nullopt, head_on()});
      expect_color(centre(p), black, 0, "no light");
    }
}

// Shadow maps and the maps of light that a base passes are read by one shader.
TEST_P(Render, maps_of_passed_light_are_read_where_shadows_are_too) {
  scene::Material sheet = dielectric(0.5f);
  sheet.double_sided = true;
  sheet.diffuse_transmission = 1.0f;
  scene::Material pane = glass(0.0f);
  pane.thickness = 0.0f;
  pane.base_color = {0.25f, 0.8f, 0.4f, 1.0f};
  const auto drawn = [&](bool mapped) {
    scene::Scene scene = square(sheet);
    scene::Material& m = scene.materials[0];
    constexpr float half = 128.0f / 255.0f;
    if (mapped) {
      m.diffuse_transmission_map = add_texture(scene, 1, 1, {255, 255, 255, 128});
      m.diffuse_transmission_color_map = add_texture(scene, 1, 1, {255, 255, 0, 255});
    } else {
      m.diffuse_transmission = half;
      m.diffuse_transmission_color = {1.0f, 1.0f, 0.0f};
    }
    scene::Light sun;
    sun.kind = scene::LightKind::directional;
    sun.direction = glm::normalize(glm::vec3(0.1f, 0.2f, 1.0f)); // from behind
    scene.lights = {sun};
    const auto behind = [](float x) {
      return glm::scale(glm::translate(glm::mat4(1.0f), {x, 0.0f, -0.3f}), glm::vec3(0.25f));
    };
    add(scene, square(dielectric(1.0f)), behind(0.3f));
    add(scene, square(pane), behind(-0.3f));
    return draw(scene, {std::nullopt, head_on()});
  };
  const image::Image by_factors = drawn(false), by_maps = drawn(true);
  EXPECT_GT(centre(by_factors).x, 0.05f);
  for (std::size_t i = 0; i < by_maps.values.size(); ++i)
    ASSERT_NEAR(by_maps.values[i], by_factors.values[i], 1e-5f) << i;
}

} // namespace gg::test::surfaces_test
