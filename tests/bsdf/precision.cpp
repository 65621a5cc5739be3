// What single precision keeps: the plain facets where input is well conditioned, the compensated
// ones everywhere. Truth is the compensated facet in double, which keeps 30 digits; the device and
// an independent truth are measured in tests/stability.
#include "glsl/f32.h"
#include "glsl/f64.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

namespace {

namespace f32 = gg::glsl::f32;
namespace f64 = gg::glsl::f64;

constexpr double right_angle = 1.5707963267948966;

// D and V of one distribution by its number, 0 GGX, 1 Beckmann, 2 Phong (width converted in
// double), then the lobe.
#define GG_VALUE(precision, Real)                                                                  \
  Real value(const precision::Facet& f, int distribution, bool transmits, Real alpha, Real e,      \
             Real eta, Real& d) {                                                                  \
    namespace p = precision;                                                                       \
    d = distribution == 0   ? p::ggxD(f.h, alpha)                                                  \
        : distribution == 1 ? p::beckmannD(f.h, alpha)                                             \
                            : p::phongD(f.h, e);                                                   \
    const Real v = distribution == 0   ? p::ggxV(f.wi, f.wo, alpha)                                \
                   : distribution == 1 ? p::beckmannV(f.wi, f.wo, alpha)                           \
                                       : p::phongV(f.wi, f.wo, e);                                 \
    return transmits ? p::transmissionScatter(f, d, v, eta) : p::reflectionF(f, d, v, eta);        \
  }
GG_VALUE(f32, float)
GG_VALUE(f64, double)
#undef GG_VALUE

// What is hard about a configuration.
enum class Class {
  ordinary,
  grazing,
  narrow,
  grazing_mirror,
  near_index_one,
  straight_through,
  critical,
  retro
};
constexpr Class classes[] = {Class::ordinary,       Class::grazing,        Class::narrow,
                             Class::grazing_mirror, Class::near_index_one, Class::straight_through,
                             Class::critical,       Class::retro};

class Cases {
public:
  Cases(Class kind, bool transmits, int distribution, bool tilted)
      : kind_(kind), transmits_(transmits), distribution_(distribution), tilted_(tilted),
        random_(42) {}

  // Relative errors of the plain and of the compensated facet over `count` draws. Values that leave
  // float32 (D under 1e-30, f over 1e38) are not asked for, nor are impossible configurations.
  void run(int count, std::vector<double>& plain, std::vector<double>& precise) {
    for (int i = 0; i < count; ++i)
      one(plain, precise);
  }

private:
  double uniform() { return std::uniform_real_distribution<double>()(random_); }
  double between(double low, double high) {
    return low * std::pow(high / low, uniform());
  } // evenly in the logarithm
  f64::vec3 at(double theta) {
    const double phi = 4 * right_angle * uniform();
    return {std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)};
  }
  f64::vec3 anywhere() { return at(std::acos(1 - 2 * uniform())); }

  f64::vec3 facet_normal(double alpha) {
    const f64::vec2 u(uniform(), uniform());
    if (distribution_ == 0) return f64::ggxSample(alpha, u);
    if (distribution_ == 1) return f64::beckmannSample(alpha, u);
    return f64::phongSample(f64::phongExponent(alpha), u);
  }

  void one(std::vector<double>& plain, std::vector<double>& precise) {
    double alpha = between(0.1, 1.0),
           eta = uniform() < 0.5 ? between(1.05, 2.5) : 1 / between(1.05, 2.5);
    double theta = std::acos(between(0.1, 1.0));
    if (kind_ == Class::narrow) alpha = between(1e-4, 1e-2);
    if (kind_ == Class::near_index_one || kind_ == Class::straight_through)
      eta = 1 + (uniform() < 0.5 ? 1 : -1) * between(1e-6, 1e-1);
    if (kind_ == Class::grazing || kind_ == Class::grazing_mirror)
      theta = right_angle - between(1e-6, 1e-1);
    if (kind_ == Class::critical) {
      eta = 1 / between(1.05, 2.5);
      theta =
          std::min(std::asin(eta) + (uniform() < 0.5 ? 1 : -1) * between(1e-6, 1e-2), right_angle);
    }
    f64::vec3 wo = at(theta), m = facet_normal(alpha);
    if (kind_ == Class::grazing_mirror) m = f64::normalize(f64::vec3(0, 0, 1) + 1e-5 * anywhere());
    f64::vec3 wi = transmits_ ? f64::refractAbout(wo, m, eta) : f64::reflectAbout(wo, m);
    if (kind_ == Class::straight_through && transmits_)
      wi = f64::normalize(-wo + 1e-5 * anywhere());
    if (kind_ == Class::retro && !transmits_) wi = f64::normalize(wo + 1e-4 * anywhere());
    f64::vec3 n(0, 0, 1);
    if (tilted_) {
      n = anywhere();
      const f64::vec3 x = f64::normalize(
          f64::cross(std::abs(n.x) < 0.5 ? f64::vec3(1, 0, 0) : f64::vec3(0, 1, 0), n));
      const f64::vec3 y = f64::cross(n, x);
      wi = wi.x * x + wi.y * y + wi.z * n;
      wo = wo.x * x + wo.y * y + wo.z * n;
    }
    compare(f32::vec3(wi), f32::vec3(wo), f32::vec3(n), float(alpha), float(eta), plain, precise);
  }

  // Truth takes the rounded inputs as exact.
  void compare(f32::vec3 wi, f32::vec3 wo, f32::vec3 n, float alpha, float eta,
               std::vector<double>& plain, std::vector<double>& precise) {
    const auto exponent = float(f64::phongExponent(double(alpha)));
    const f64::vec3 i(wi), o(wo), up(n);
    const f64::Facet truth = transmits_ ? f64::preciseTransmissionFacet(i, o, up, double(eta))
                                        : f64::preciseReflectionFacet(i, o, up, double(eta));
    double d = 0;
    const double exact =
        value(truth, distribution_, transmits_, double(alpha), double(exponent), double(eta), d);
    if (!(d > 1e-30 && exact > 1e-30 && exact < 1e38)) return;
    float ignored = 0;
    const auto error = [&](const f32::Facet& f) {
      return std::abs(
          double(value(f, distribution_, transmits_, alpha, exponent, eta, ignored)) / exact - 1);
    };
    plain.push_back(error(transmits_ ? f32::transmissionFacet(wi, wo, n, eta)
                                     : f32::reflectionFacet(wi, wo, n, eta)));
    precise.push_back(error(transmits_ ? f32::preciseTransmissionFacet(wi, wo, n, eta)
                                       : f32::preciseReflectionFacet(wi, wo, n, eta)));
  }

  Class kind_;
  bool transmits_;
  int distribution_;
  bool tilted_;
  std::mt19937_64 random_;
};

TEST(precision, of_ordinary_values_in_float_is_a_few_ulp) {
  std::vector<double> plain, precise;
  for (bool transmits : {false, true})
    for (int distribution : {0, 1, 2})
      Cases(Class::ordinary, transmits, distribution, false).run(2000, plain, precise);
  ASSERT_GT(plain.size(), 7000U);
  std::ranges::sort(plain);
  EXPECT_LT(plain[plain.size() / 2], 3e-7);
  EXPECT_LT(plain[plain.size() * 99 / 100],
            4e-6); // alpha down to 0.1 turns each ulp of a direction into ten
}

TEST(precision, of_the_compensated_facet_is_five_digits_in_every_class) {
  constexpr double stated =
      1.4e-5; // where D is 1e-30, exp multiplies the rounding of its argument by 70
  for (Class kind : classes)
    for (bool transmits : {false, true})
      for (int distribution : {0, 1, 2})
        for (bool tilted : {false, true}) {
          std::vector<double> plain, precise;
          Cases(kind, transmits, distribution, tilted).run(400, plain, precise);
          ASSERT_GT(precise.size(), 20U) << int(kind) << transmits << distribution << tilted;
          std::ranges::sort(precise);
          EXPECT_LT(precise.back(), stated) << int(kind) << transmits << distribution << tilted;
          EXPECT_LT(precise[precise.size() / 2], 5e-7)
              << int(kind) << transmits << distribution << tilted;
        }
}

TEST(precision, of_narrow_ggx_comes_from_the_vector_and_not_from_its_cosine) {
  // At alpha 1e-3 and 1e-3 rad from the normal.
  const float alpha = 1e-3F;
  const f32::vec3 m(1e-3F, 0.0F, 0.9999995F);
  const double exact = f64::ggxD(f64::tilt(f64::vec3(m)), double(alpha));
  EXPECT_NEAR(double(f32::ggxD(f32::tilt(m), alpha)) / exact, 1, 6e-7);
  const float c = m.z, c2 = c * c, b = c2 * (alpha * alpha - 1.0F) + 1.0F; // the usual way
  EXPECT_GT(std::abs(double(alpha * alpha / (3.14159265F * b * b)) / exact - 1), 0.01);
}

TEST(compensated, agrees_with_the_plain_facet_in_double) {
  for (double theta : {0.3, 1.2, 2.5, 2.8}) {
    const f64::vec3 wo(std::sin(0.6), 0, std::cos(0.6)), n(0, 0, 1);
    const f64::vec3 wi(-std::sin(theta) * 0.8, std::sin(theta) * 0.6, std::cos(theta));
    const bool reflects = wi.z > 0;
    const f64::Facet a =
        reflects ? f64::reflectionFacet(wi, wo, n, 1.5) : f64::transmissionFacet(wi, wo, n, 1.5);
    const f64::Facet b = reflects ? f64::preciseReflectionFacet(2.0 * wi, 0.3 * wo, 5.0 * n, 1.5)
                                  : f64::preciseTransmissionFacet(2.0 * wi, 0.3 * wo, 5.0 * n, 1.5);
    ASSERT_TRUE(a.exists && b.exists);
    constexpr double rounding = 1e-12;
    EXPECT_NEAR(f64::tiltCos(a.h), f64::tiltCos(b.h), rounding);
    EXPECT_NEAR(f64::tiltCos(a.wi), f64::tiltCos(b.wi), rounding);
    EXPECT_NEAR(f64::tiltCos(a.wo), f64::tiltCos(b.wo), rounding);
    EXPECT_NEAR(a.woDotM, b.woDotM, rounding);
    EXPECT_NEAR(a.wiDotM, b.wiDotM, rounding);
    EXPECT_NEAR(a.s, b.s, rounding);
    EXPECT_NEAR(a.g, b.g, rounding);
  }
}

TEST(twin, sums_and_products_are_exact) {
  std::mt19937 random(3);
  std::uniform_real_distribution<float> any(-1.0F, 1.0F);
  for (int i = 0; i < 1000; ++i) {
    const f32::vec3 a(any(random), any(random), any(random)),
        b(any(random), any(random), 1e-5F * any(random));
    const f32::Twin3 sum = f32::twinSum(a, b), product = f32::twinProduct(a, b);
    for (int k = 0; k < 3; ++k) {
      EXPECT_EQ(double(sum.hi[k]) + double(sum.lo[k]), double(a[k]) + double(b[k]));
      EXPECT_EQ(double(product.hi[k]) + double(product.lo[k]), double(a[k]) * double(b[k]));
    }
  }
}

} // namespace
