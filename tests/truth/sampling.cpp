// What is drawn at random is drawn with the density that is claimed for it.
#include "truth/beckmann_visible.h"
#include "truth/closure.h"
#include "truth/estimate.h"
#include "truth/mis.h"
#include "truth/surface.h"

#include <numbers>

namespace {

using namespace gg;
using namespace gg::truth;
using namespace gg::truth::test;

constexpr double pi = std::numbers::pi;

// A mean of independent values with its standard error.
struct Mean {
  double sum = 0.0, squares = 0.0;
  long n = 0;
  void add(double x) { sum += x, squares += x * x, ++n; }
  double mean() const { return sum / static_cast<double>(n); }
  double error() const {
    const double m = mean();
    return std::sqrt(std::max(squares / static_cast<double>(n) - m * m, 0.0)
                     / static_cast<double>(n - 1));
  }
};

constexpr double sigmas = 5.0; // one chance in 1.7 million

glm::dvec3 uniform_direction(Random& random) {
  const double z = 2.0 * random.uniform() - 1.0, phi = 2.0 * pi * random.uniform();
  const double r = std::sqrt(1.0 - z * z);
  return {r * std::cos(phi), r * std::sin(phi), z};
}

// How often directions fall into the cells of a sphere (equal areas), against the integral of the
// density there, by chi-square.
template <class Sample, class Pdf>
void expect_histogram_matches(const Sample& sample, const Pdf& pdf, const std::string& what) {
  constexpr int rows = 12, columns = 12, draws = 60000, fine = 16;
  std::vector<double> expected(rows * columns, 0.0), seen(rows * columns, 0.0);
  const auto cell = [](const glm::dvec3& d) {
    const int row = std::clamp(static_cast<int>((d.z + 1.0) / 2.0 * rows), 0, rows - 1);
    const int column = std::clamp(
        static_cast<int>((std::atan2(d.y, d.x) / (2.0 * pi) + 0.5) * columns), 0, columns - 1);
    return static_cast<std::size_t>(row * columns + column);
  };
  for (int i = 0; i < rows * fine; ++i)
    for (int j = 0; j < columns * fine; ++j) {
      const double z = 2.0 * (i + 0.5) / (rows * fine) - 1.0;
      const double phi = 2.0 * pi * ((j + 0.5) / (columns * fine) - 0.5);
      const double r = std::sqrt(1.0 - z * z);
      const glm::dvec3 d(r * std::cos(phi), r * std::sin(phi), z);
      expected[cell(d)] += pdf(d) * 4.0 * pi / (rows * columns * fine * fine);
    }
  long drawn = 0;
  for (int k = 0; k < draws; ++k) {
    Random random(7, 0, static_cast<std::uint64_t>(k));
    if (const std::optional<glm::dvec3> d = sample(random)) {
      seen[cell(*d)] += 1.0;
      ++drawn;
    }
  }
  double chi2 = 0.0, pooled_expected = 0.0, pooled_seen = 0.0;
  int cells = 0;
  const auto count = [&](double e, double s) {
    chi2 += (s - e) * (s - e) / e;
    ++cells;
  };
  for (std::size_t i = 0; i < expected.size(); ++i) {
    const double e = expected[i] * draws;
    if (e >= 20.0) {
      count(e, seen[i]);
    } else {
      pooled_expected += e;
      pooled_seen += seen[i];
    }
  }
  if (pooled_expected >= 5.0) count(pooled_expected, pooled_seen);
  ASSERT_GT(cells, 5) << what;
  // Chi-square of k cells has mean k and variance 2 k; the midpoint sums of the density add less
  // than another k.
  EXPECT_LT(chi2, 2.0 * cells + sigmas * std::sqrt(2.0 * cells))
      << what << ", " << drawn << " drawn";
}

TEST(truth_beckmann, visible_normals_have_their_density) {
  for (const double alpha : {0.3, 1.0})
    for (const double cos_o : {1.0, 0.5, 0.05}) {
      const glm::dvec3 wo(std::sqrt(1.0 - cos_o * cos_o), 0.0, cos_o);
      expect_histogram_matches(
          [&](Random& random) { return std::optional(beckmann_sample_visible(wo, alpha, random)); },
          [&](const glm::dvec3& m) {
            glsl::f64::Facet f{};
            f.h = glsl::f64::tilt(m);
            f.wo = glsl::f64::tilt(wo);
            f.woDotM = glm::dot(wo, m);
            f.exists = m.z > 0.0 && f.woDotM > 0.0;
            return beckmann_pdf_visible(f, alpha);
          },
          "alpha " + std::to_string(alpha) + ", cos " + std::to_string(cos_o));
    }
}

struct NamedInterface {
  const char* name;
  Interface interface;
};

// Coats have a normal of their own, near that of the surface and on wo's side.
Interface over(Interface interface, const glm::dvec3& n, const glm::dvec3& wo) {
  if (interface.coat)
    interface.coat->n = face_viewer(glm::normalize(n + glm::dvec3(0.1, -0.2, 0.1)), wo);
  return interface;
}

std::vector<NamedInterface> interfaces() {
  const Interface glass{.alpha = 0.35, .eta = 1.5, .transmit = glm::dvec3(1.0)};
  Interface leaving = glass, plastic = glass, mixed = glass, tinted = glass, beckmann = glass,
            phong = glass, correlated = glass, metal = glass, coated = glass, brushed = glass,
            film = glass, sheet = glass, layered = glass;
  leaving.eta = 1.0 / 1.5;
  plastic.transmit = glm::dvec3(0.0);
  plastic.diffuse = {0.8, 0.5, 0.1};
  mixed.diffuse = {0.3, 0.2, 0.1};
  mixed.transmit = {0.3, 0.6, 0.6};
  mixed.metallic = 0.4;
  mixed.metal_f0 = {0.9, 0.5, 0.2};
  tinted.tinted = TintedReflectance{{0.1, 0.05, 0.02}, 0.7};
  beckmann.distribution = scene::Distribution::beckmann;
  phong.distribution = scene::Distribution::phong;
  correlated.smith = Smith::correlated;
  metal.metallic = 1.0;
  metal.metal = scene::Conductor{{0.2f, 0.9f, 1.4f}, {3.9f, 2.5f, 1.8f}};
  coated.transmit = glm::dvec3(0.0);
  coated.diffuse = {0.8, 0.5, 0.1};
  coated.coat = Coat{.strength = 0.8, .alpha = 0.2, .n = {}};
  brushed.brushing = Brushing{.alpha = {0.6, 0.15}, .along = glm::normalize(glm::dvec3(1, 2, 2))};
  film.transmit = glm::dvec3(0.0);
  film.metallic = 0.5;
  film.metal_f0 = {0.9, 0.5, 0.2};
  film.film = ThinFilm{.share = 0.9, .ior = 1.35, .thickness = 420.0};
  sheet.transmit = glm::dvec3(0.0);
  sheet.diffuse = {0.3, 0.2, 0.1};
  sheet.diffuse_behind = {0.2, 0.4, 0.5};
  sheet.coat = coated.coat;
  layered.film = film.film;
  layered.coat = Coat{.strength = 0.8, .alpha = 0.2, .n = {}};
  return {{"layered glass", layered}, {"coated sheet", sheet}, {"coated plastic", coated},
          {"brushed glass", brushed}, {"film on metal", film}, {"entering glass", glass},
          {"leaving glass", leaving}, {"plastic", plastic},    {"mixed", mixed},
          {"tinted", tinted},         {"Beckmann", beckmann},  {"Phong", phong},
          {"correlated", correlated}, {"gold", metal}};
}

TEST(truth_closure, directions_are_drawn_with_their_density) {
  for (const NamedInterface& i : interfaces())
    for (const double cos_o : {0.95, 0.3}) {
      // Aslant, so that no lobe sits on a pole of the grid.
      const glm::dvec3 n(2.0 / 3.0, 1.0 / 3.0, 2.0 / 3.0),
          across(-1.0 / 3.0, -2.0 / 3.0, 2.0 / 3.0);
      const glm::dvec3 wo = cos_o * n + std::sqrt(1.0 - cos_o * cos_o) * across;
      const Closure closure(over(i.interface, n, wo), n, wo);
      expect_histogram_matches(
          [&](Random& random) {
            const Draws draws = closure.sample(random);
            return draws.empty() ? std::nullopt : std::optional(draws.begin()->wi);
          },
          [&](const glm::dvec3& wi) { return closure.evaluate(wi).pdf; },
          std::string(i.name) + ", cos " + std::to_string(cos_o));
    }
}

TEST(truth_closure, weights_average_to_the_integral_of_f_cos) {
  for (const NamedInterface& i : interfaces())
    for (const double cos_o : {0.95, 0.3}) {
      const glm::dvec3 n(0.0, 0.0, 1.0), wo(std::sqrt(1.0 - cos_o * cos_o), 0.0, cos_o);
      const Closure closure(over(i.interface, n, wo), n, wo);
      Mean drawn_mean, uniform_mean;
      for (std::uint64_t k = 0; k < 100000; ++k) {
        Random random(3, 0, k);
        double sum = 0.0;
        for (const Drawn& drawn : closure.sample(random))
          sum += drawn.weight.x;
        drawn_mean.add(sum);
        uniform_mean.add(closure.evaluate(uniform_direction(random)).f_cos.x * 4.0 * pi);
      }
      EXPECT_NEAR(drawn_mean.mean(), uniform_mean.mean(),
                  sigmas * std::hypot(drawn_mean.error(), uniform_mean.error()))
          << i.name << ", cos " << cos_o;
    }
}

// Of a channel, of what was drawn on one side of the interface.
double weight_of(const Draws& draws, bool across) {
  double sum = 0.0;
  for (const Drawn& drawn : draws)
    if (drawn.transmitted == across) sum += drawn.weight.y;
  return sum;
}

// Where both sides are worth it both are followed, with the weights that make the same light of it;
// and the densities, which multiple importance sampling weighs them by, are those of both.
TEST(truth_closure, splitting_changes_the_paths_and_not_the_light) {
  const glm::dvec3 n(0.0, 0.0, 1.0), wo(0.6, 0.0, 0.8);
  for (const NamedInterface& named : interfaces())
    for (const double alpha : {0.0, named.interface.alpha}) {
      Interface interface = over(named.interface, n, wo);
      interface.alpha = alpha;
      const Closure one(interface, n, wo), split(interface, n, wo, {.power = 1.0});
      Mean means[2][2], densities; // one or split, reflected or transmitted
      long pairs = 0;
      constexpr std::uint64_t samples = 40000;
      for (std::uint64_t k = 0; k < samples; ++k) {
        Random first(7, 0, k), second(8, 0, k), third(9, 0, k);
        const Draws x = one.sample(first), y = split.sample(second);
        EXPECT_LE(x.end() - x.begin(), 1);
        if (y.end() - y.begin() == 2) ++pairs;
        for (const bool across : {false, true}) {
          means[0][across].add(weight_of(x, across));
          means[1][across].add(weight_of(y, across));
        }
        densities.add(split.evaluate(uniform_direction(third)).pdf * 4.0 * pi
                      - static_cast<double>(y.end() - y.begin()));
      }
      for (const bool across : {false, true})
        EXPECT_NEAR(means[0][across].mean(), means[1][across].mean(),
                    sigmas * std::hypot(means[0][across].error(), means[1][across].error()) + 1e-9)
            << named.name << ", alpha " << alpha << (across ? ", transmitted" : ", reflected");
      if (alpha > 0.0) {
        EXPECT_NEAR(densities.mean(), 0.0, sigmas * densities.error()) << named.name;
      }
      if (interface.eta != 1.5 || !(interface.transmit.x > 0.9) || interface.metallic > 0.0)
        continue;
      EXPECT_GT(pairs, static_cast<long>(samples) / 2) << named.name << ", alpha " << alpha;
    }
}

TEST(truth_closure, smooth_lobes_are_the_limit_of_narrow_ones) {
  for (const NamedInterface& named : interfaces()) {
    // Phong is not sampled by what the viewer sees, but agrees in the limit all the same.
    Interface narrow = named.interface, smooth = named.interface;
    narrow.alpha = 1e-4;
    smooth.alpha = 0.0;
    const glm::dvec3 n(0.0, 0.0, 1.0), wo(0.6, 0.0, 0.8);
    const Closure a(narrow, n, wo), b(smooth, n, wo);
    Mean means[2][2]; // narrow or smooth, reflected or transmitted
    for (std::uint64_t k = 0; k < 20000; ++k) {
      Random first(5, 0, k), second(6, 0, k);
      const Draws x = a.sample(first), y = b.sample(second);
      for (const bool across : {false, true}) {
        means[0][across].add(weight_of(x, across));
        means[1][across].add(weight_of(y, across));
      }
    }
    for (const bool across : {false, true})
      EXPECT_NEAR(means[0][across].mean(), means[1][across].mean(),
                  sigmas * std::hypot(means[0][across].error(), means[1][across].error()) + 1e-3)
          << named.name << (across ? ", transmitted" : ", reflected");
  }
}

// A dark sky with a bright disc, a sun of few texels, and black patches.
environment::Map sky() {
  environment::Map map = black_map(64, 32);
  for (int y = 0; y < map.height; ++y)
    for (int x = 0; x < map.width; ++x)
      for (int c = 0; c < 3; ++c)
        texel(map, x, y)[c] = y > 20 && x < 32 ? 0.0f : 0.1f * static_cast<float>(c + 1);
  for (int c = 0; c < 3; ++c)
    texel(map, 40, 8)[c] = 5000.0f;
  return map;
}

TEST(truth_environment, density_integrates_to_one_and_estimates_the_same_light) {
  const EnvironmentLight light(sky(), 0.7, 2.0);
  Mean density, uniform, drawn, all, both;
  constexpr double sphere = 1.0 / (4.0 * pi); // density of a uniform direction
  for (std::uint64_t k = 0; k < 400000; ++k) {
    Random random(11, 0, k);
    const glm::dvec3 d = uniform_direction(random);
    density.add(light.pdf(d) * 4.0 * pi);
    const double there = light.radiance(d).y * 4.0 * pi;
    all.add(there);
    uniform.add(light.pdf(d) > 0.0 ? there : 0.0);
    const auto s = light.sample(random);
    ASSERT_TRUE(s);
    const double found = light.radiance(s->place).y / s->pdf;
    drawn.add(found);
    both.add(mis_share(s->pdf, sphere) * found + mis_share(sphere, light.pdf(d)) * there);
  }
  EXPECT_NEAR(density.mean(), 1.0, sigmas * density.error());
  EXPECT_NEAR(drawn.mean(), uniform.mean(), sigmas * std::hypot(drawn.error(), uniform.error()));
  // What is dimmer than the mean is never drawn, and not lost to those who look for it themselves.
  EXPECT_NEAR(both.mean(), all.mean(), sigmas * std::hypot(both.error(), all.error()));
  EXPECT_LT(both.error(), 0.1 * all.error());
  // It is there for a reason: the sun is ten times less noisy than without.
  EXPECT_LT(drawn.error(), 0.1 * uniform.error());
}

TEST(truth_environment, one_that_is_equally_bright_everywhere_is_left_to_the_surfaces) {
  const EnvironmentLight light = constant_environment({0.3f, 0.7f, 1.1f});
  Random random(1, 0, 0);
  EXPECT_FALSE(light.sample(random));
  EXPECT_EQ(light.pdf(glm::dvec3(0.0, 1.0, 0.0)), 0.0);
  constexpr double rounding = 1e-6; // of the floats
  EXPECT_NEAR(light.mean_radiance(), 0.7, rounding);
}

TEST(truth_environment, directions_are_where_the_convention_puts_them) {
  // u = atan2(z, x) / 2 pi + 1/2, v = acos(y) / pi: +X in the middle, +Z at three quarters.
  environment::Map map = black_map(8, 4);
  texel(map, 4, 2)[0] = texel(map, 3, 2)[0] = texel(map, 4, 1)[0] = texel(map, 3, 1)[0] =
      1.0f; // +X red
  texel(map, 6, 2)[1] = texel(map, 5, 2)[1] = texel(map, 6, 1)[1] = texel(map, 5, 1)[1] =
      1.0f; // +Z green
  for (int x = 0; x < 8; ++x)
    texel(map, x, 0)[2] = 1.0f; // +Y blue
  const EnvironmentLight light(map, 0.0, 1.0);
  EXPECT_EQ(light.radiance({1.0, 0.0, 0.0}), glm::dvec3(1.0, 0.0, 0.0));
  EXPECT_EQ(light.radiance({0.0, 0.0, 1.0}), glm::dvec3(0.0, 1.0, 0.0));
  EXPECT_EQ(light.radiance({0.0, 1.0, 0.0}), glm::dvec3(0.0, 0.0, 1.0));
  // A quarter turn, counter-clockwise seen from above, takes +X to -Z and +Z to +X.
  const EnvironmentLight turned(map, pi / 2.0, 3.0);
  constexpr double rounding = 1e-12;
  EXPECT_NEAR(turned.radiance({0.0, 0.0, -1.0}).x, 3.0, rounding);
  EXPECT_NEAR(turned.radiance({1.0, 0.0, 0.0}).y, 3.0, rounding);
}

TEST(truth_random, batches_are_counted_as_they_come) {
  long batches = 0;
  for (long k = 0; k < 3000; ++k) {
    const Batch batch = batch_of(k);
    ASSERT_LE(batch.first, k);
    ASSERT_LT(k, batch.first + batch.size);
    ASSERT_EQ(batch.first % batch.size, 0) << k;
    batches += k == batch.first;
    ASSERT_EQ(batches_of(k + 1), batches) << k;
  }
}

// Of 16 samples, each pair of numbers has one point in each of 16 x 1, 8 x 2, 4 x 4, 2 x 8 and 1 x 16
// cells: a (0,4,2)-net [Niederreiter87].
TEST(truth_random, numbers_of_a_batch_are_stratified_in_pairs) {
  constexpr int count = 16, pairs = 8;
  for (std::uint64_t pixel = 0; pixel < 20; ++pixel) {
    std::array<std::array<glm::dvec2, pairs>, count> points;
    for (int k = 0; k < count; ++k) {
      Random random = Random::stratified(5, pixel, 64 + k);
      for (glm::dvec2& p : points[static_cast<std::size_t>(k)])
        p = random.uniform2();
    }
    for (std::size_t pair = 0; pair < pairs; ++pair)
      for (int wide = 1; wide <= count; wide *= 2) {
        std::set<int> cells;
        for (const auto& point : points) {
          const int x = static_cast<int>(point[pair].x * wide);
          const int y = static_cast<int>(point[pair].y * (count / wide));
          cells.insert(y * wide + x);
        }
        EXPECT_EQ(cells.size(), count) << pixel << ", pair " << pair << ", " << wide;
      }
  }
}

// Each by itself, whatever its place in the batch: the mean has no bias.
TEST(truth_random, stratified_numbers_are_uniform) {
  constexpr int batches = 4000, bins = 8;
  for (const int place : {0, 7, 15}) {
    std::array<int, bins> seen{};
    for (std::uint64_t pixel = 0; pixel < batches; ++pixel) {
      Random random = Random::stratified(9, pixel, 64 + place);
      for (int skipped = 0; skipped < 5; ++skipped)
        random.uniform();
      ++seen[static_cast<std::size_t>(random.uniform() * bins)];
    }
    // Chi² of 7 degrees of freedom is above 29.9 once in 10,000.
    double chi2 = 0.0;
    for (const int n : seen)
      chi2 += std::pow(n - batches / bins, 2) / (batches / static_cast<double>(bins));
    EXPECT_LT(chi2, 29.9) << place;
  }
}

} // namespace
