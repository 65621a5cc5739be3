// Included by degenerate.cpp once per precision, in a namespace that sees the snippets of that precision and `Real`.

vec3 at(double theta, double phi) {
  return vec3(Real(std::sin(theta) * std::cos(phi)), Real(std::sin(theta) * std::sin(phi)), Real(std::cos(theta)));
}

  // Directions where things go wrong: the axes, the horizon, within an ulp of each, and a few plain
  // ones.
  std::vector<vec3> directions() {
    std::vector<vec3> all;
    for (double theta : {0.0, 1e-8, 1e-4, 0.5, 1.2, 1.5707, 1.5707963, 1.5707963267948966, 1.570797,
                         1.9, 2.8, 3.1415, 3.141592653589793})
      for (double phi : {0.0, 1e-7, 1.0, 3.141592653589793})
        all.push_back(at(theta, phi));
    all.push_back(vec3(1, 0, 0));
    all.push_back(vec3(-1, 0, 0));
    all.push_back(vec3(0, 0, 1));
    all.push_back(vec3(0));
    return all;
  }

std::string where;

void expect_sane(Real x, const char* what) {
  EXPECT_TRUE(x >= 0 && x <= std::numeric_limits<Real>::max())
      << what << " = " << x << " at " << where;
}


TEST(GG_SUITE, lobes_and_pdfs_are_finite_and_not_negative) {
  const auto all = directions();
  const vec3 n(0, 0, 1);
  for (double a : {0.0, 1e-4, 0.01, 0.5, 1.0})
    for (double e : {0.0, 0.25, 0.666, 0.999999, 1.0, 1.000001, 1.5, 4.0})
      for (const auto& wi : all)
        for (const auto& wo : all) {
          const Real alpha = Real(a), eta = Real(e), exponent = phongExponent(alpha);
          where = testing::PrintToString(std::vector<double>{a, e, double(wi.x), double(wi.y),
                                                             double(wi.z), double(wo.x),
                                                             double(wo.y), double(wo.z)});
          for (const auto& f :
               {reflectionFacet(wi, wo, n, eta), preciseReflectionFacet(wi, wo, n, eta)}) {
            expect_sane(reflectionF(f, ggxD(f.h, alpha), ggxV(f.wi, f.wo, alpha), eta),
                        "f_r ggx");
            expect_sane(
                reflectionF(f, ggxD(f.h, alpha), ggxVCorrelated(f.wi, f.wo, alpha), eta),
                "f_r correlated");
            expect_sane(
                reflectionF(f, beckmannD(f.h, alpha), beckmannV(f.wi, f.wo, alpha), eta),
                "f_r beckmann");
            expect_sane(
                reflectionF(f, phongD(f.h, exponent), phongV(f.wi, f.wo, exponent), eta),
                "f_r phong");
            expect_sane(reflectionPdf(f, ggxPdf(f.h, alpha)), "pdf_r");
            expect_sane(reflectionPdf(f, ggxPdfVisible(f, alpha)), "pdf_r visible");
          }
          for (const auto& f : {transmissionFacet(wi, wo, n, eta),
                                preciseTransmissionFacet(wi, wo, n, eta)}) {
            expect_sane(transmissionF(f, ggxD(f.h, alpha), ggxV(f.wi, f.wo, alpha), eta),
                        "f_t ggx");
            expect_sane(
                transmissionF(f, ggxD(f.h, alpha), ggxVBeta(f.wi, f.wo, alpha), eta),
                "f_t beta");
            expect_sane(
                transmissionF(f, beckmannD(f.h, alpha), beckmannV(f.wi, f.wo, alpha), eta),
                "f_t beckmann");
            expect_sane(
                transmissionF(f, phongD(f.h, exponent), phongV(f.wi, f.wo, exponent), eta),
                "f_t phong");
            expect_sane(transmissionPdf(f, ggxPdf(f.h, alpha), eta), "pdf_t");
            expect_sane(transmissionPdf(f, ggxPdfVisible(f, alpha), eta), "pdf_t visible");
          }
        }
}

TEST(GG_SUITE, impossible_sides_are_exactly_zero) {
  const vec3 n(0, 0, 1), above = at(0.4, 0), other = at(0.9, 2),
                         below = at(2.5, 3);
  const Real eta(1.5);
  EXPECT_FALSE(reflectionFacet(above, below, n, eta).exists);
  EXPECT_FALSE(transmissionFacet(above, other, n, eta).exists);
  EXPECT_FALSE(reflectionFacet(vec3(1, 0, 0), above, n, eta).exists);
  EXPECT_FALSE(transmissionFacet(vec3(1, 0, 0), above, n, eta).exists);
  EXPECT_FALSE(transmissionFacet(below, above, n, Real(1)).exists);
  EXPECT_FALSE(transmissionFacet(below, above, n, Real(0)).exists);
  EXPECT_FALSE(transmissionFacet(-above, above, n, Real(1)).exists);
  EXPECT_TRUE(reflectionFacet(below, at(2.9, 0), n, eta)
                  .exists); // both below: the other side's mirror
  // A facet that stands exactly upright: wo.z + eta wi.z = 0, with wo and wi on its two sides.
  const Real half(0.5), quarter(0.25), x = Real(std::sqrt(0.9375)), y = Real(std::sqrt(0.75));
  EXPECT_FALSE(transmissionFacet(vec3(-y, 0, -half), vec3(x, 0, quarter), n, half).exists);
  EXPECT_FALSE(preciseTransmissionFacet(vec3(-y, 0, -half), vec3(x, 0, quarter), n, half).exists);
  const auto none = reflectionFacet(above, below, n, eta);
  EXPECT_EQ(reflectionF(none, Real(1), Real(1), eta), 0);
  EXPECT_EQ(transmissionF(none, Real(1), Real(1), eta), 0);
  EXPECT_EQ(transmissionScatter(none, Real(1), Real(1), eta), 0);
  EXPECT_EQ(reflectionPdf(none, Real(1)), 0);
  EXPECT_EQ(transmissionPdf(none, Real(1), eta), 0);
}

TEST(GG_SUITE, fresnel_answers_any_angle_and_index) {
  for (double c : {-2.0, -0.5, 0.0, 1e-30, 1e-7, 0.5, 1.0, 3.0})
    for (double n : {-1.0, 0.0, 1e-6, 0.5, 1.0, 1.5, 100.0}) {
      for (double k : {-1.0, 0.0, 1e-6, 1.0, 100.0}) {
        const Real f = fresnelConductor(Real(c), Real(n), Real(k)),
                   a = fresnelAbsorbed(Real(c), Real(n), Real(k));
        EXPECT_TRUE(f >= 0 && f <= 1 && a >= 0 && a <= 1) << c << " " << n << " " << k;
      }
      const Real f = fresnelDielectricAt(Real(c), Real(n)),
                 t = fresnelTransmittedAt(Real(c), Real(n));
      EXPECT_TRUE(f >= 0 && f <= 1 && t >= 0 && t <= 1) << c << " " << n;
      if (n <= 0) {
        EXPECT_EQ(f, 1);
      }
    }
}

// wi . h = 1 + wi . wo is never negative, but for its rounding: index 1 has to be told, not found out.
TEST(GG_SUITE, matched_indices_have_no_facet_however_straight_the_light) {
  const vec3 n(0, 0, 1);
  for (int i = 0; i < 2000; ++i) {
    const vec3 wo = at(0.3 + 1e-4 * i, 0.001 * i), wi = at(3.141592653589793 - 0.3 - 1e-4 * i, 3.141592653589793 + 0.001 * i);
    EXPECT_FALSE(transmissionFacet(wi, wo, n, Real(1)).exists) << i;
    EXPECT_FALSE(preciseTransmissionFacet(wi, wo, n, Real(1)).exists) << i;
  }
}
