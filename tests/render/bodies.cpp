// What app/README.md's "Bodies of glass" says, in frames and in the path tracer: the same along chosen rays.
#include "render/harness.h"
#include "render/shapes.h"
#include "support/pictures.h"
#include "truth/integrator.h"

#include <glm/gtc/matrix_transform.hpp>

#include <optional>

namespace gg::test::bodies_test {
namespace {

constexpr int size = 96;
constexpr int middle = size / 2;

frame::FrameDesc from(const glm::vec3& eye) {
  return {.width = size, .height = size, .samples = 1, .camera = camera_at(eye)};
}

// What the path tracer finds along the frame's ray through the pixel.
struct Traced {
  glm::dvec3 mean{0.0};
  double error = 0.0; // of the mean, largest channel
};
Traced traced(const scene::Scene& scene, const glm::vec3& radiance, const scene::Camera& camera,
              int x, int y, long samples) {
  const truth::EnvironmentLight light(environment::constant(radiance), 0.0, 1.0);
  const truth::Integrator integrator(scene, &light, std::nullopt, {});
  const truth::Ray ray{glm::dvec3(camera.world[3]), view_direction(camera, size, size, x, y)};
  glm::dvec3 sum(0.0), squares(0.0);
  for (long k = 0; k < samples; ++k) {
    truth::Random random(1, 0, static_cast<std::uint64_t>(k));
    const glm::dvec3 value = integrator.trace(ray, random).radiance;
    sum += value;
    squares += value * value;
  }
  const double n = static_cast<double>(samples);
  const glm::dvec3 mean = sum / n, variance = (squares / n - mean * mean) / n;
  return {mean, std::sqrt(std::max({variance.x, variance.y, variance.z, 0.0}))};
}

constexpr double sigmas = 4.0;

// The lower half of a ball as a material of its own, the second.
scene::Scene in_halves(const scene::Scene& whole) {
  scene::Scene parts = whole;
  const scene::Indices all = parts.indices[0];
  const auto half = all.begin() + static_cast<std::ptrdiff_t>(all.size() / 6 * 3);
  parts.indices[0] = scene::Indices(all.begin(), half);
  parts.indices.push_back(scene::Indices(half, all.end()));
  parts.materials.push_back(parts.materials[0]);
  parts.meshes[0].primitives.push_back(parts.meshes[0].primitives[0]);
  parts.meshes[0].primitives[1].indices = 1;
  parts.meshes[0].primitives[1].material = 1;
  return parts;
}

} // namespace

TEST_P(Render, partly_clear_solids_show_what_the_path_tracer_finds) {
  // The base within is lit alike from all sides and metal counts as diffuse there; white light all
  // around leaves of that a few hundredths.
  constexpr double frames_own = 0.035;
  for (const float transmission : {0.9f, 0.5f, 0.1f})
    for (const float metallic : {0.0f, 0.3f}) {
      scene::Material m = glass(0.0f);
      m.base_color = glm::vec4(0.9f, 0.5f, 0.2f, 1.0f);
      m.transmission = transmission;
      m.metallic = metallic;
      const scene::Scene scene = ball(m);
      const frame::FrameDesc desc = from({0, 0, 4});
      const image::Image picture = draw(scene, {environment::constant(glm::vec3(1.0f)), desc});
      for (const int x : {middle, middle + 12, middle + 20}) {
        const Traced truth = traced(scene, glm::vec3(1.0f), desc.camera, x, middle, 4000);
        for (int c = 0; c < 3; ++c)
          EXPECT_NEAR(picture.at(x, middle, c), truth.mean[c], frames_own + sigmas * truth.error)
              << "transmission " << transmission << ", metallic " << metallic << ", x " << x
              << ", channel " << c;
      }
    }
}

TEST_P(Render, a_body_of_two_materials_is_drawn_as_one) {
  const scene::Scene whole = ball(glass(0.3f));
  const scene::Scene parts = in_halves(whole);
  const frame::FrameDesc desc = from({0, 1.5f, 4});
  const environment::Map sky = environment_of(
      128, [](const glm::dvec3& d) { return glm::dvec3(1.0 + d.y, 1.0 + d.x, 1.0 - d.z); });
  const image::Image one = draw(whole, {sky, desc}), two = draw(parts, {sky, desc});
  // Pixels are shaded by triangles where two materials take part, by the layer's rounded normals where one does.
  constexpr double rounded_normals = 0.02;
  for (std::size_t i = 0; i < one.values.size(); ++i)
    ASSERT_NEAR(two.values[i], one.values[i], rounded_normals) << "value " << i;
}

TEST_P(Render, the_far_side_of_a_body_shows_its_own_colour) {
  // Red glass behind clear glass; then paint.
  constexpr double frames_own = 0.035; // see above
  for (const float transmission : {1.0f, 0.0f}) {
    scene::Scene scene = in_halves(ball(glass(0.0f)));
    scene.materials[1].base_color = glm::vec4(0.9f, 0.2f, 0.1f, 1.0f);
    scene.materials[1].transmission = transmission;
    const frame::FrameDesc desc = from({0, 4, 1});
    const image::Image picture = draw(scene, {environment::constant(glm::vec3(1.0f)), desc});
    for (const int x : {middle, middle + 12}) {
      const Traced truth = traced(scene, glm::vec3(1.0f), desc.camera, x, middle, 2000);
      for (int c = 0; c < 3; ++c)
        EXPECT_NEAR(picture.at(x, middle, c), truth.mean[c], frames_own + sigmas * truth.error)
            << "transmission " << transmission << ", x " << x << ", channel " << c;
    }
  }
}

TEST_P(Render, a_body_is_there_whatever_the_order_of_materials) {
  scene::Scene scene = square(unlit(glm::vec3(0.5f)));
  scene.instances[0].world =
      glm::scale(glm::translate(glm::mat4(1.0f), {0, 0, -2}), glm::vec3(9.0f));
  add(scene, ball(glass(0.0f)), glm::mat4(1.0f));
  scene::Scene turned = scene;
  std::swap(turned.materials[0], turned.materials[1]);
  for (scene::Mesh& mesh : turned.meshes)
    mesh.primitives[0].material = 1 - mesh.primitives[0].material;
  const environment::Map sky = environment::constant(glm::vec3(1.0f));
  EXPECT_EQ(draw(turned, {sky, from({0, 0, 4})}).values,
            draw(scene, {sky, from({0, 0, 4})}).values);
}

TEST_P(Render, light_passes_one_pane_of_glass_after_another) {
  scene::Material pane = glass(0.0f);
  pane.thickness = 0.0f;
  pane.double_sided = true; // light comes from behind it too
  scene::Scene scene = square(dielectric(1.0f));
  scene.instances[0].world = glm::scale(glm::mat4(1.0f), glm::vec3(3.0f));
  for (int k = 1; k <= 6; ++k)
    add(scene, square(pane),
        glm::translate(glm::mat4(1.0f), {0, 0, 0.05f * static_cast<float>(k)}));
  const frame::FrameDesc desc = from({0, 0, 6});
  const image::Image picture = draw(scene, {environment::constant(glm::vec3(1.0f)), desc});
  const Traced truth = traced(scene, glm::vec3(1.0f), desc.camera, middle, middle, 4000);
  constexpr double frames_own = 0.05; // form factors; light between the panes is left out
  EXPECT_NEAR(picture.at(middle, middle, 1), truth.mean.y, frames_own + sigmas * truth.error);
}

TEST_P(Render, alpha_says_once_whether_a_body_is_there) {
  scene::Material m = glass(0.0f);
  m.base_color.w = 0.4f;
  m.attenuation_color = glm::vec3(0.3f);
  m.attenuation_distance = 1.0f;
  m.alpha_mode = scene::AlphaMode::blend;
  scene::Scene scene = ball(m);
  add(scene, square(unlit(glm::vec3(0.5f))),
      glm::scale(glm::translate(glm::mat4(1.0f), {0, 0, -2}), glm::vec3(9.0f)));
  const frame::FrameDesc desc = from({0, 0, 4});
  const image::Image picture = draw(scene, {environment::constant(glm::vec3(1.0f)), desc});
  constexpr double frames_own = 0.01;
  for (const int x : {middle, middle + 12}) {
    const Traced truth = traced(scene, glm::vec3(1.0f), desc.camera, x, middle, 4000);
    EXPECT_NEAR(picture.at(x, middle, 0), truth.mean.x, frames_own + sigmas * truth.error) << x;
  }
}

TEST_P(Render, an_open_sheet_with_a_thickness_is_a_plate) {
  scene::Material m = glass(0.0f);
  m.thickness = 0.5f;
  m.attenuation_color = {0.25f, 0.5f, 1.0f};
  m.attenuation_distance = 0.5f;
  const scene::Scene scene = square(m);
  constexpr double frames_own = 0.01;
  for (const glm::vec3 eye : {glm::vec3(0, 0, 4), glm::vec3(3, 0, 3)}) {
    const frame::FrameDesc desc = from(eye);
    const image::Image picture = draw(scene, {environment::constant(glm::vec3(1.0f)), desc});
    const Traced truth = traced(scene, glm::vec3(1.0f), desc.camera, middle, middle, 4000);
    for (int c = 0; c < 3; ++c)
      EXPECT_NEAR(picture.at(middle, middle, c), truth.mean[c], frames_own + sigmas * truth.error)
          << eye.x << ", channel " << c;
  }
}

} // namespace gg::test::bodies_test
