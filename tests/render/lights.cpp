// Punctual lights against the formulas of KHR_lights_punctual and the BSDF in double precision.
#include "glsl/f64.h"
#include "render/head_on.h"

#include <cmath>
#include <numbers>

namespace gg::test::lights_test {
namespace {

namespace f64 = glsl::f64;

constexpr int size = head_on_size;
// Rounding: a dozen float32 operations of the shader on coordinates that were themselves
// interpolated.
constexpr double rounding = 2e-5;

scene::Light light(scene::LightKind kind) {
  scene::Light l;
  l.kind = kind;
  l.intensity = {3.0f, 2.0f, 1.0f};
  l.position = {0.5f, 0.3f, 0.8f};
  l.direction = glm::normalize(glm::vec3(-0.4f, -0.2f, -1.0f));
  return l;
}

struct Model {
  const char* name;
  scene::Distribution distribution;
  bool correlated;
};
const Model models[] = {{"ggx", scene::Distribution::ggx, false},
                        {"ggx, correlated", scene::Distribution::ggx, true},
                        {"beckmann", scene::Distribution::beckmann, false},
                        {"phong", scene::Distribution::phong, false}};

double d_times_v(const Model& model, const f64::Facet& f, double alpha) {
  if (model.distribution == scene::Distribution::beckmann)
    return f64::beckmannD(f.h, alpha) * f64::beckmannV(f.wi, f.wo, alpha);
  if (model.distribution == scene::Distribution::phong) {
    const double exponent = f64::phongExponent(alpha);
    return f64::phongD(f.h, exponent) * f64::phongV(f.wi, f.wo, exponent);
  }
  return f64::ggxD(f.h, alpha)
         * (model.correlated ? f64::ggxVCorrelated(f.wi, f.wo, alpha)
                             : f64::ggxV(f.wi, f.wo, alpha));
}

// f cos of a glTF dielectric of index 1.5 with a base of `albedo`.
double dielectric_f_cos(const Model& model, glm::dvec3 wi, glm::dvec3 wo, double alpha,
                        double albedo) {
  const auto facet = f64::reflectionFacet(wi, wo, glm::dvec3(0, 0, 1), 1.5);
  const double fresnel = f64::fresnelDielectric(facet.woDotM, facet.g, 1.5);
  return (d_times_v(model, facet, alpha) * fresnel + (1.0 - fresnel) * albedo / std::numbers::pi)
         * wi.z;
}

// The irradiance factor and direction of a light at a point, as the extension defines them.
struct Arrival {
  glm::dvec3 wi;
  double factor;
};
Arrival arrival(const scene::Light& l, glm::dvec3 at) {
  if (l.kind == scene::LightKind::directional)
    return {-glm::normalize(glm::dvec3(l.direction)), 1.0};
  const glm::dvec3 to = glm::dvec3(l.position) - at;
  const double d = glm::length(to);
  double factor = 1.0 / (d * d);
  if (std::isfinite(l.range))
    factor *= std::clamp(1.0 - std::pow(d / static_cast<double>(l.range), 4.0), 0.0, 1.0);
  if (l.kind == scene::LightKind::spot) {
    const double cosine = glm::dot(glm::normalize(glm::dvec3(l.direction)), -to / d);
    const double inner = std::cos(static_cast<double>(l.inner_cone)),
                 outer = std::cos(static_cast<double>(l.outer_cone));
    const double falloff = std::clamp((cosine - outer) / std::max(0.001, inner - outer), 0.0, 1.0);
    factor *= falloff * falloff;
  }
  return {to / d, factor};
}

} // namespace

TEST_P(Render, punctual_lights_follow_their_formulas_at_every_pixel) {
  std::vector<scene::Light> kinds;
  kinds.push_back(light(scene::LightKind::directional));
  kinds.push_back(light(scene::LightKind::point));
  kinds.push_back(light(scene::LightKind::point));
  kinds.back().range = 1.2f;
  kinds.push_back(light(scene::LightKind::spot));
  kinds.back().inner_cone = 0.2f;
  kinds.back().outer_cone = 0.6f;
  for (const Model& model : models)
    for (const scene::Light& l : kinds)
      for (const float roughness : {0.3f, 0.9f}) {
        scene::Scene scene = square(dielectric(roughness, glm::vec3(0.5f)));
        scene.materials[0].distribution = model.distribution;
        scene.lights = {l};
        frame::FrameDesc desc = head_on();
        desc.correlated_smith = model.correlated;
        const image::Image picture = draw(scene, {std::nullopt, desc});
        double worst = 0.0;
        for (int y = 0; y < size; ++y)
          for (int x = 0; x < size; ++x) {
            const glm::dvec3 at = on_square(x, y);
            const Arrival a = arrival(l, at);
            const glm::dvec3 wo = glm::normalize(glm::dvec3(0, 0, 2) - at);
            const double alpha = static_cast<double>(roughness) * static_cast<double>(roughness);
            const double value = a.factor * dielectric_f_cos(model, a.wi, wo, alpha, 0.5);
            for (int c = 0; c < 3; ++c) {
              const double expected = value * static_cast<double>(l.intensity[c]);
              worst = std::max(worst, std::abs(picture.at(x, y, c) - expected) / (expected + 0.01));
            }
          }
        EXPECT_LT(worst, rounding * 50) << model.name << ", kind " << static_cast<int>(l.kind)
                                        << ", range " << l.range << ", roughness " << roughness;
      }
}

TEST_P(Render, many_lights_add_up) {
  scene::Scene scene = square(dielectric(0.5f));
  const auto lit_by = [&](std::vector<scene::Light> lights) {
    scene.lights = std::move(lights);
    return draw(scene, {std::nullopt, head_on()});
  };
  scene::Light a = light(scene::LightKind::point), b = light(scene::LightKind::directional);
  const image::Image one = lit_by({a}), other = lit_by({b}), both = lit_by({a, b});
  double worst = 0.0;
  for (std::size_t i = 0; i < both.values.size(); ++i)
    if (i % 4 != 3)
      worst = std::max(
          worst, std::abs(static_cast<double>(both.values[i]) - one.values[i] - other.values[i]));
  EXPECT_LT(worst, rounding);
}

TEST_P(Render, a_light_at_the_surface_or_behind_it_draws_no_nan_and_no_light) {
  scene::Scene scene = square(dielectric(0.5f));
  scene.lights = {light(scene::LightKind::point)};
  scene.lights[0].position = {0, 0, -1};
  const image::Image picture = draw(scene, {std::nullopt, head_on()});
  for (std::size_t i = 0; i < picture.values.size(); i += 4)
    ASSERT_EQ(picture.values[i], 0.0f);
  scene.lights[0].position = glm::vec3(on_square(20, 20)); // draw() scans for NaN
  draw(scene, {std::nullopt, head_on()});
}

} // namespace gg::test::lights_test
