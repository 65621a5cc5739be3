// Solids of every kind of surface in light that comes from everywhere alike, seen from outside and
// from within. What absorbs nothing shows radiance 1 outside and the square of the index inside.
// Prints the table that it checks.
#include "glsl/f64.h"
#include "truth/estimate.h"
#include "truth/scenes.h"

#include <fmt/core.h>

#include <numbers>

namespace {

using namespace gg;
using namespace gg::truth;
using namespace gg::truth::test;
namespace f64 = gg::glsl::f64;

constexpr float ior = 1.5f;

struct Kind {
  std::string name;
  scene::Material material;
  bool lossless = true; // nothing absorbs, and no facet hides another
};

std::vector<Kind> kinds() {
  std::vector<Kind> all;
  const auto add = [&](const std::string& name, bool lossless, float alpha,
                       const std::function<void(scene::Material&)>& change) {
    scene::Material m = glass(alpha);
    change(m);
    all.push_back({name, m, lossless});
  };
  for (const float t : {1.0f, 0.99f, 0.9f, 0.5f, 0.1f})
    for (const float alpha : {0.0f, 0.3f})
      add(fmt::format("transmission {}, alpha {}", t, alpha), alpha == 0.0f, alpha,
          [&](scene::Material& m) { m.transmission = t; });
  for (const float metallic : {0.5f, 1.0f})
    for (const float alpha : {0.0f, 0.3f})
      add(fmt::format("metallic {}, alpha {}", metallic, alpha), alpha == 0.0f, alpha,
          [&](scene::Material& m) {
            m.transmission = 0.8f;
            m.metallic = metallic;
          });
  add("transmission 0.5, grey", false, 0.0f, [](scene::Material& m) {
    m.transmission = 0.5f;
    m.base_color = glm::vec4(0.5f, 0.5f, 0.5f, 1.0f);
  });
  add("transmission 0.5, absorbs", false, 0.0f, [](scene::Material& m) {
    m.transmission = 0.5f;
    m.attenuation_color = glm::vec3(0.5f);
    m.attenuation_distance = 1.0f;
  });
  add("transmission 0.5, specular 0.5", true, 0.0f, [](scene::Material& m) {
    m.transmission = 0.5f;
    m.specular = 0.5f;
  });
  add("transmission map", true, 0.0f, [](scene::Material& m) { m.transmission_map.texture = 0; });
  add("metallic map", true, 0.0f, [](scene::Material& m) {
    m.metallic = 1.0f;
    m.transmission = 0.8f;
    m.metallic_roughness_map.texture = 0;
  });
  return all;
}

// A checkerboard in all channels: half of the surface of each kind.
void add_checkers(scene::Scene& scene) {
  auto image = std::make_shared<image::Image8>();
  image->width = image->height = 2;
  for (const std::uint8_t v : std::array<std::uint8_t, 4>{255, 0, 0, 255})
    image->rgba.insert(image->rgba.end(), {v, v, v, 255});
  scene.images = {image};
  scene.textures = {{.image = 0, .sampler = {.magnify = scene::Filter::nearest}}};
}

// By how much glTF's white base under a smooth coat reflects more than the coat leaves: the base
// takes 1 - F at the half-vector, and F itself is met at the viewer's angle.
double surplus_of_white_base(double cos_o) {
  const glm::dvec3 wo(std::sqrt(1.0 - cos_o * cos_o), 0.0, cos_o);
  constexpr int n = 300;
  double base = 0.0;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      const double r2 = (i + 0.5) / n, phi = 2.0 * std::numbers::pi * (j + 0.5) / n;
      const glm::dvec3 wi(std::sqrt(r2) * std::cos(phi), std::sqrt(r2) * std::sin(phi),
                          std::sqrt(1.0 - r2));
      const double c = glm::dot(wo, glm::normalize(wo + wi));
      base += 1.0 - f64::fresnelDielectricAt(c, static_cast<double>(ior));
    }
  return f64::fresnelDielectricAt(cos_o, static_cast<double>(ior)) + base / (n * n) - 1.0;
}

TEST(truth_furnace, no_solid_gives_more_than_it_gets_and_lossless_ones_give_all) {
  const EnvironmentLight white = constant_environment(glm::vec3(1.0f));
  constexpr double eta2 = static_cast<double>(ior * ior);
  // 64 rings: shading normals are a degree off the facets' at most, and move the surplus by as much.
  constexpr int rings = 64;
  constexpr double facets = 2e-3;
  fmt::print("radiance of a solid in a white furnace, within it over the index squared\n"
             "{:32} {:>18} {:>18} {:>18} {:>18}\n",
             "surface", "along the normal", "37 degrees", "60 degrees", "from within");
  for (const Kind& kind : kinds()) {
    scene::Scene scene;
    add_checkers(scene);
    add_ball(scene, kind.material, glm::vec3(0.0f), 1.0f, rings);
    const Integrator outside = integrator_of(scene, &white);
    const glm::dvec3 eye(0.2, 0.1, -0.3);
    const Integrator within(scene, &white, eye, {});
    std::string row = fmt::format("{:32}", kind.name);
    const auto check = [&](const Estimate& e, double expected, double slack, const char* where) {
      row += fmt::format(" {:8.4f} +- {:.4f}", e.mean.x / expected, e.error.x / expected);
      if (kind.lossless) {
        EXPECT_TRUE(agrees(e, glm::dvec3(expected), slack)) << kind.name << ", " << where;
      }
      EXPECT_LT(e.mean.x, expected + 5.0 * e.error.x + slack) << kind.name << ", " << where;
    };
    for (const double x : {0.0, 0.6, 0.866}) {
      const double cos_o = std::sqrt(1.0 - x * x);
      // Of maps and of specular the share of the base is not one number: the surplus bounds it.
      const double surplus = surplus_of_white_base(cos_o);
      const bool mixed = kind.material.transmission_map || kind.material.metallic_roughness_map
                         || kind.material.specular != 1.0f;
      const double base = (1.0 - static_cast<double>(kind.material.metallic))
                          * (1.0 - static_cast<double>(kind.material.transmission));
      check(trace(outside, {{x, 0.02, 5.0}, {0.0, 0.0, -1.0}}, 4000),
            1.0 + (mixed ? 0.0 : base * surplus), facets + (mixed ? std::abs(surplus) : 0.0),
            "outside");
    }
    const Estimate inner = trace(within, {eye, glm::normalize(glm::dvec3(0.3, 0.2, 1.0))}, 4000);
    // Into a hull of metal nothing comes.
    if (kind.material.metallic < 1.0f || kind.material.metallic_roughness_map)
      check(inner, eta2, facets, "from within");
    fmt::print("{}\n", row);
  }
}

} // namespace
