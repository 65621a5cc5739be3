// Coats over a surface, films on it, and brushing: against their formulas in double precision.
#include "core/files.h"
#include "glsl/f64.h"
#include "render/head_on.h"
#include "scene/framing.h"
#include "scene/load.h"
#include "truth/environment_light.h"
#include "truth/integrator.h"

#include <cmath>
#include <numbers>

namespace gg::test::layers_test {
namespace {

namespace f64 = glsl::f64;

constexpr int size = head_on_size;
// A dozen float32 operations on interpolated coordinates, and lobes that divide by alpha.
constexpr double rounding = 1e-3;

const glm::dvec3 sun_from = glm::normalize(glm::dvec3(0.5, 0.2, 1.0));

void add_sun(scene::Scene& scene) {
  scene::Light light;
  light.kind = scene::LightKind::directional;
  light.direction = -glm::vec3(sun_from);
  scene.lights = {light};
}

// The largest relative difference from `expected(wo)` over all pixels of the square.
double worst(const image::Image& picture,
             const std::function<glm::dvec3(const glm::dvec3&)>& expected) {
  double most = 0.0;
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x) {
      const glm::dvec3 at = on_square(x, y);
      const glm::dvec3 value = expected(glm::normalize(glm::dvec3(0, 0, 2) - at));
      const glm::dvec3 off = glm::abs(rgb(picture, x, y) - value) / (value + 0.01);
      most = std::max({most, off.x, off.y, off.z});
    }
  return most;
}

const glm::dvec3 up(0, 0, 1);

double ggx_lobe(const glm::dvec3& wo, double alpha) {
  const f64::Facet f = f64::reflectionFacet(sun_from, wo, up, 1.5);
  return f64::ggxD(f.h, alpha) * f64::ggxV(f.wi, f.wo, alpha) * f.wi.z;
}

scene::Material coated_metal(float roughness, float coat_roughness, float strength = 1.0f) {
  scene::Material m = metal(roughness);
  m.clearcoat = strength;
  m.clearcoat_roughness = coat_roughness;
  return m;
}

} // namespace

// Between samples of a pixel at the rim of a disc, every lobe of a brushed surface can lie below its horizon.
TEST_P(Render, brushed_discs_beside_each_other_are_finite_at_their_rims) {
  const scene::Scene scene =
      scene::load(home_directory() / "assets/scenes/AnisotropyStrengthTest.glb");
  constexpr int width = 320, height = 240; // one sample of pixel (256, 66) sees such a rim
  draw(scene,
       {.environment = environment_of(8, [](const glm::dvec3&) { return glm::dvec3(1.0); }),
        .desc = {.width = width,
                 .height = height,
                 .samples = 16,
                 .camera = scene::default_camera(scene, static_cast<float>(width) / height)}});
}

TEST_P(Render, a_coat_takes_from_what_is_under_it_what_it_reflects_itself) {
  for (const float strength : {0.5f, 1.0f}) {
    scene::Scene scene = square(coated_metal(0.7f, 0.5f, strength));
    add_sun(scene);
    const double base = 0.7f * 0.7f, coat = 0.25;
    EXPECT_LT(worst(draw(scene, {std::nullopt, head_on()}),
                    [&](const glm::dvec3& wo) {
                      const double share =
                          static_cast<double>(strength) * f64::fresnelDielectricAt(wo.z, 1.5);
                      return glm::dvec3((1.0 - share) * ggx_lobe(wo, base)
                                        + share * ggx_lobe(wo, coat));
                    }),
              rounding)
        << strength;
  }
}

TEST_P(Render, a_coat_dims_the_light_that_its_base_emits) {
  scene::Material m = coated_metal(0.5f, 0.0f);
  m.base_color = glm::vec4(0.0f, 0.0f, 0.0f, 1.0f);
  m.emissive = glm::vec3(2.0f, 1.0f, 0.5f);
  EXPECT_LT(worst(draw(square(m), {std::nullopt, head_on()}),
                  [](const glm::dvec3& wo) {
                    return (1.0 - f64::fresnelDielectricAt(wo.z, 1.5)) * glm::dvec3(2.0, 1.0, 0.5);
                  }),
            rounding);
}

// All that the base is not shown of, a smooth coat shows; a rough one loses what single scattering does, of its share alone.
TEST_P(Render, a_coated_ball_in_the_white_furnace_loses_nothing_but_by_its_facets) {
  constexpr double tabulated = 0.006; // albedos of the tables
  frame::FrameDesc desc = head_on();
  desc.camera = camera_at({0, 0, 3.2f});
  const auto furnace = [&](const scene::Material& m) {
    return draw(ball(m), {environment::constant(glm::vec3(1.0f)), desc});
  };
  const image::Image smooth = furnace(coated_metal(0.0f, 0.0f));
  for (const float v : smooth.values)
    EXPECT_NEAR(v, 1.0f, 1e-3f);
  const image::Image bare = furnace(metal(0.0f)), rough = furnace(coated_metal(0.0f, 0.6f)),
                     all_rough = furnace(metal(0.6f));
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x) {
      const auto n =
          hit_ball(glm::dvec3(desc.camera.world[3]), view_direction(desc.camera, size, size, x, y));
      if (!n) continue;
      const glm::dvec3 d = view_direction(desc.camera, size, size, x, y);
      const double c = -glm::dot(*n, d);
      if (c < 0.1) continue; // the outline runs through the pixel
      const double share = f64::fresnelDielectricAt(c, 1.5);
      EXPECT_NEAR(rough.at(x, y), (1.0 - share) * bare.at(x, y) + share * all_rough.at(x, y),
                  tabulated);
    }
}

TEST_P(Render, brushed_metal_has_the_lobe_of_two_widths_along_its_tangent) {
  for (const float rotation : {0.0f, 0.7f})
    for (const bool correlated : {false, true}) {
      scene::Material m = metal(0.5f);
      m.anisotropy_strength = 0.6f;
      m.anisotropy_rotation = rotation;
      scene::Scene scene = square(m);
      add_sun(scene);
      frame::FrameDesc desc = head_on();
      desc.correlated_smith = correlated;
      // The square's tangent is x, its bitangent y.
      const double r = static_cast<double>(rotation);
      const glm::dvec3 along(std::cos(r), std::sin(r), 0.0), across(-std::sin(r), std::cos(r), 0.0);
      const glm::dvec2 alpha(0.25 + 0.75 * 0.36, 0.25);
      const auto local = [&](const glm::dvec3& v) {
        return glm::dvec3(glm::dot(v, along), glm::dot(v, across), v.z);
      };
      EXPECT_LT(worst(draw(scene, {std::nullopt, desc}),
                      [&](const glm::dvec3& wo) {
                        const glm::dvec3 i = local(sun_from), o = local(wo);
                        const double v = correlated ? f64::ggxAnisoVCorrelated(i, o, alpha)
                                                    : f64::ggxAnisoV(i, o, alpha);
                        return glm::dvec3(f64::ggxAnisoD(i + o, alpha) * v * i.z);
                      }),
                rounding)
          << rotation << (correlated ? ", correlated" : "");
    }
}

TEST_P(Render, brushed_metal_in_the_white_furnace_loses_what_its_facets_shadow) {
  scene::Material m = metal(0.7f);
  m.anisotropy_strength = 0.6f;
  const image::Image picture = draw(square(m), {environment::constant(glm::vec3(1.0f)), head_on()});
  const glm::dvec2 widths = f64::ggxAnisoWidths(0.49, 0.6);
  constexpr int facets = 4096, middle = size / 2;
  const glm::dvec3 wo = glm::normalize(glm::dvec3(0, 0, 2) - on_square(middle, middle));
  double albedo = 0.0;
  for (int i = 0; i < facets; ++i) {
    const glm::dvec2 u((i + 0.5) / facets, std::fmod(0.5 + i * std::numbers::phi, 1.0));
    const glm::dvec3 wi = f64::reflectAbout(wo, f64::ggxSampleVisible(wo, widths, u));
    if (wi.z > 0.0) albedo += f64::ggxAnisoG1(wi, widths) / facets;
  }
  EXPECT_NEAR(picture.at(middle, middle), albedo, 0.03) << "the worst of the fit head on";
}

TEST_P(Render, brushing_spreads_the_environment_along_it_and_not_across) {
  // A bright band at the horizon's height: metal brushed along y smears it, brushed along x keeps it.
  const auto band = environment_of(
      256, [](const glm::dvec3& d) { return glm::dvec3(std::abs(d.y) < 0.1 ? 10.0 : 0.0); });
  const auto middle = [&](float rotation) {
    scene::Material m = metal(0.2f);
    m.anisotropy_strength = 0.8f;
    m.anisotropy_rotation = rotation;
    const image::Image picture = draw(square(m), {band, head_on()});
    return picture.at(size / 2, size / 2);
  };
  EXPECT_GT(middle(0.0f), 3.0f * middle(0.5f * std::numbers::pi_v<float>));
}

TEST_P(Render, a_film_on_a_mirror_has_its_colours) {
  scene::Material m = metal(0.0f, glm::vec3(0.9f, 0.6f, 0.4f));
  m.iridescence = 0.75f;
  m.iridescence_ior = 1.4f;
  m.iridescence_thickness = glm::vec2(0.0f, 350.0f);
  const glm::dvec3 f0(m.base_color);
  const glm::dvec3 base(f64::filmBaseIor(f0.x), f64::filmBaseIor(f0.y), f64::filmBaseIor(f0.z));
  EXPECT_LT(worst(draw(square(m), {environment::constant(glm::vec3(1.0f)), head_on()}),
                  [&](const glm::dvec3& wo) {
                    const glm::dvec3 bare = f64::fresnelSchlickRgb(wo.z, f0);
                    return glm::mix(
                        bare,
                        f64::filmFresnel(wo.z, static_cast<double>(m.iridescence_ior), 350.0, base),
                        0.75);
                  }),
            4.0 * rounding); // environments are half floats
}

scene::Material sheet() {
  scene::Material m = dielectric(0.5f);
  m.base_color = {0.8f, 0.7f, 0.4f, 1.0f};
  m.diffuse_transmission = 0.6f;
  m.diffuse_transmission_color = {0.9f, 0.5f, 0.2f};
  return m;
}

TEST_P(Render, light_that_a_base_passes_comes_from_its_other_side) {
  scene::Scene scene = square(sheet());
  scene.materials[0].double_sided = true;
  add_sun(scene);
  scene.lights[0].direction.z *= -1.0f;
  const glm::dvec3 color = 0.6 * glm::dvec3(0.9, 0.5, 0.2) / std::numbers::pi;
  EXPECT_LT(worst(draw(scene, {std::nullopt, head_on()}),
                  [&](const glm::dvec3& wo) {
                    const f64::Facet f = f64::reflectionFacet(sun_from, wo, up, 1.5);
                    return (1.0 - f64::fresnelDielectricAt(f.woDotM, 1.5)) * f.wi.z * color;
                  }),
            rounding);
}

// Where as much is to be passed as to be reflected.
TEST_P(Render, in_the_white_furnace_it_is_all_one_to_which_side_a_base_sends_its_light) {
  scene::Material m = sheet();
  m.diffuse_transmission_color = glm::vec3(m.base_color);
  scene::Material opaque = m;
  opaque.diffuse_transmission = 0.0f;
  const auto white = environment::constant(glm::vec3(1.0f));
  const image::Image a = draw(square(m), {white, head_on()}),
                     b = draw(square(opaque), {white, head_on()});
  for (std::size_t i = 0; i < a.values.size(); ++i)
    ASSERT_NEAR(a.values[i], b.values[i], 1e-3f);
}

// Without an environment a path's one vertex is lit by the sun alone, and nothing is left to chance.
TEST_P(Render, what_extensions_say_of_dielectrics_is_what_the_path_tracer_takes_them_for) {
  scene::Material tinted = dielectric(0.5f), dull = tinted, glowing = tinted, bare = tinted,
                  brushed = tinted, filmed = tinted, coated = tinted;
  tinted.ior = 1.8f;
  tinted.specular = 0.3f;
  tinted.specular_color = {1.0f, 0.4f, 2.0f};
  dull.specular = 0.0f;
  glowing.emissive = {6.0f, 3.0f, 1.0f}; // a strength is in it by now
  bare.unlit = true;
  brushed.anisotropy_strength = 0.6f;
  brushed.anisotropy_rotation = 0.4f;
  filmed.iridescence = 0.8f;
  coated.clearcoat = 0.9f;
  coated.clearcoat_roughness = 0.4f;
  for (const scene::Material& m : {tinted, dull, glowing, bare, brushed, filmed, coated, sheet()}) {
    scene::Scene scene = square(m);
    add_sun(scene);
    const frame::FrameDesc desc = head_on();
    const image::Image picture = draw(scene, {std::nullopt, desc});
    const truth::Integrator integrator(scene, nullptr, std::nullopt, {});
    for (const int x : {8, 40}) {
      truth::Random random(1, 0, 0);
      const glm::dvec3 expected = integrator
                                      .trace({glm::dvec3(desc.camera.world[3]),
                                              view_direction(desc.camera, size, size, x, 20)},
                                             random)
                                      .radiance;
      const glm::dvec3 off = glm::abs(rgb(picture, x, 20) - expected) / (expected + 0.01);
      EXPECT_LT(std::max({off.x, off.y, off.z}), rounding)
          << x << ", specular " << m.specular << ", film " << m.iridescence << ", coat "
          << m.clearcoat << ", brushing " << m.anisotropy_strength;
    }
  }
}

// In a white furnace a body of glass shows what of the light its faces do not shadow: steep facets along the brushing shadow much,
// and those of one slope alone little (without the former the ball was a third too bright).
TEST_P(Render, brushed_glass_loses_to_shadowing_what_paths_lose) {
  scene::Material m = glass(std::sqrt(0.2f));
  m.anisotropy_strength = 0.6f;
  const scene::Scene scene = ball(m);
  const environment::Map white = environment::constant(glm::vec3(1.0f));
  const frame::FrameDesc desc{.width = size,
                              .height = size,
                              .samples = 16,
                              .camera = camera_at({0, 0, 4}),
                              .method = frame::Method::lobes2};
  const image::Image picture = draw(scene, {white, desc});
  const truth::EnvironmentLight light(white, 0.0, 1.0);
  const truth::Integrator integrator(scene, &light, std::nullopt, {});
  double drawn = 0.0, traced = 0.0;
  int pixels = 0;
  for (int y = 1; y < size; y += 3)
    for (int x = 1; x < size; x += 3) {
      const glm::dvec3 eye(desc.camera.world[3]), d = view_direction(desc.camera, size, size, x, y);
      if (!hit_ball(eye, d)) continue;
      drawn += rgb(picture, x, y).x;
      constexpr int paths = 128; // in all some 10,000: a noise of half a hundredth
      truth::Random random(1, static_cast<std::uint64_t>(y * size + x), 0);
      for (int i = 0; i < paths; ++i)
        traced += integrator.trace({eye, d}, random).radiance.x / paths;
      ++pixels;
    }
  ASSERT_GT(pixels, 50);
  EXPECT_NEAR(drawn / traced, 1.0, 0.08) << traced / pixels << ": the lobes' own error";
}

} // namespace gg::test::layers_test
