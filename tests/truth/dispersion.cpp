// Glass whose index depends on the wavelength.
#include "truth/estimate.h"
#include "truth/scenes.h"

namespace {

using namespace gg;
using namespace gg::truth;
using namespace gg::truth::test;

// A world that is as different in every direction as in every channel.
EnvironmentLight motley() {
  environment::Map map{.name = "motley", .width = 64, .height = 32};
  for (int y = 0; y < map.height; ++y)
    for (int x = 0; x < map.width; ++x)
      for (int c = 0; c < 3; ++c)
        map.rgb.push_back(static_cast<float>((7 * x + 11 * y + 13 * c) % 17));
  return EnvironmentLight(std::move(map), 0.0, 1.0);
}

// KHR_materials_dispersion: red, green and blue see glass of three indices, each like a ball that
// has that index for all of them.
TEST(truth_dispersion, each_channel_is_bent_by_its_own_index) {
  const EnvironmentLight world = motley();
  constexpr float dispersion = 4.0f; // much: the indices are 1.45, 1.5 and 1.55
  for (const float alpha : {0.0f, 0.2f}) {
    const auto ball_of = [&](float ior, float dispersing) {
      scene::Scene scene;
      scene::Material m = glass(alpha);
      m.ior = ior;
      m.dispersion = dispersing;
      add_ball(scene, m, glm::vec3(0.0f), 1.0f, 24);
      return scene;
    };
    const scene::Scene prism = ball_of(1.5f, dispersion);
    const Integrator dispersed = integrator_of(prism, &world);
    for (const double x : {0.3, 0.7}) {
      const Ray ray{{x, 0.1, 5.0}, {0.0, 0.0, -1.0}};
      const Estimate all = trace(dispersed, ray, 20000);
      for (int c = 0; c < 3; ++c) {
        const scene::Scene plain = ball_of(1.45f + 0.05f * static_cast<float>(c), 0.0f);
        const Integrator alone = integrator_of(plain, &world);
        const Estimate one = trace(alone, ray, 20000, 2);
        EXPECT_NEAR(all.mean[c], one.mean[c],
                    5.0 * std::hypot(all.error[c], one.error[c]) + 20.0 * rounding)
            << "alpha " << alpha << ", x " << x << ", channel " << c;
      }
    }
  }
}

// Three paths of one channel each make as much light as one of three.
TEST(truth_dispersion, loses_and_tints_nothing) {
  const EnvironmentLight white = constant_environment(glm::vec3(1.0f));
  scene::Scene scene;
  scene::Material m = glass(0.0f);
  m.dispersion = 4.0f;
  add_ball(scene, m, glm::vec3(0.0f), 1.0f, 24);
  const Integrator integrator = integrator_of(scene, &white);
  for (const double x : {0.0, 0.5, 0.9})
    EXPECT_TRUE(agrees(trace(integrator, {{x, 0.05, 5.0}, {0.0, 0.0, -1.0}}, 2000), glm::dvec3(1.0),
                       rounding))
        << x;
}

} // namespace
