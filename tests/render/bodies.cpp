// What app/README.md's "Bodies of glass" says, in frames and in the path tracer: the same along chosen rays.
#include "render/harness.h"
#include "render/shapes.h"
#include "truth/integrator.h"

#include <optional>

namespace gg::test {
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

} // namespace gg::test
