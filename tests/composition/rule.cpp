// The rule's arithmetic by itself: what it must reduce to, and what it must never do.
#include "composition/truth.h"
#include "glsl/f32.h"
#include "glsl/f64.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <cmath>

namespace gg::composition_test {
namespace {

namespace f64 = gg::glsl::f64;
namespace f32 = gg::glsl::f32;
using f64::ComposedLobe;
using f64::ExitSurface;
using f64::InnerLobe;
using glm::dvec3;

constexpr double rounding = 1e-11; // some dozen operations of double, angles through atan and back

const double thetas[] = {0.0, 10.0, 35.0, 60.0, 80.0, 89.0};
const double etas[] = {0.5, 1.0 / 1.5, 1.0 / 1.1, 1.1, 1.33, 1.5, 2.4};

// A lobe as the tables hold it, of Snell's angle and `per_width` times the first-order width.
ComposedLobe compose(const InnerLobe& inner, const ExitSurface& s, const f64::Widening& k,
                     double per_width) {
  const auto view = f64::seeExit(inner, true, s, k);
  const double cosine = std::max(view.cosTheta, 0.0);
  return f64::composeLobe(inner, view, s, f64::interfaceSnell(cosine, s.eta),
                          per_width * f64::interfaceWidth(cosine, view.alphaShape, s.eta), 1.0,
                          1.0);
}

// Snell's law for a ray d that meets the outward normal n; ratio = n_inside / n_outside. False: total reflection.
bool snell(const dvec3& d, const dvec3& n, double ratio, dvec3& out) {
  const double cosine = dot(d, n);
  const dvec3 across = ratio * (d - cosine * n);
  const double rest = 1.0 - dot(across, across);
  if (!(cosine > 0.0 && rest > 0.0)) return false;
  out = across + std::sqrt(rest) * n;
  return true;
}

Configuration smooth(const Solid& solid, double eta, double theta) {
  Configuration c;
  c.solid = solid;
  c.eta = eta;
  c.theta = theta;
  return c;
}

std::vector<Solid> solids() {
  return {slab(),
          sphere(),
          wedge(15),
          wedge(-15),
          wedge_out(30),
          lens("cylinder across", {1, 50, 1}, 0.8),
          lens("cylinder along", {50, 1, 1}, 0.8),
          lens("ellipsoid", {1.5, 1.0, 1.2}, 0.6)};
}

TEST(composition, of_two_smooth_faces_is_snells_law_twice) {
  int checked = 0;
  for (const Solid& solid : solids())
    for (double eta : etas)
      for (double theta : thetas) {
        const Configuration c = smooth(solid, eta, theta);
        const dvec3 inside =
            f64::interfaceLobeDirection(c.wo(), {0, 0, 1}, f64::interfaceSnell(c.wo().z, eta));
        const Exit exit = solid.exit(inside);
        dvec3 expected;
        if (!snell(inside, exit.n, eta, expected)) continue;
        const ComposedLobe lobe = compose({inside, 0.0, 1.0}, {exit.n, 0.0, 1.0 / eta, exit.turn},
                                          f64::wideningGgx(2), 1.0);
        EXPECT_LT(length(lobe.direction - expected),
                  rounding / std::max(dot(expected, exit.n), 1e-3))
            << c.label();
        EXPECT_EQ(lobe.sigma, 0.0);
        EXPECT_EQ(lobe.weight, 1.0);
        ++checked;
      }
  EXPECT_GT(checked, 200);
}

TEST(composition, a_slab_gives_the_entering_direction_back) {
  for (double eta : etas)
    for (double theta : thetas) {
      const Configuration c = smooth(slab(), eta, theta);
      if (eta < 1.0 && std::sin(theta * degree) > eta) continue;
      const dvec3 inside =
          f64::interfaceLobeDirection(c.wo(), {0, 0, 1}, f64::interfaceSnell(c.wo().z, eta));
      const ComposedLobe lobe =
          compose({inside, 0.0, 1.0}, {{0, 0, -1}, 0.0, 1.0 / eta, {}}, f64::wideningGgx(2), 1.0);
      EXPECT_LT(length(lobe.direction + c.wo()), rounding / c.wo().z) << c.label();
    }
}

// How a smooth exit maps deviations of the ray inside, by differences: in the plane of incidence and across it.
struct Spread {
  double in_plane = 0.0, across = 0.0;
};
bool spread_of(const Solid& solid, const dvec3& inside, double eta, Spread& result) {
  constexpr double h = 1e-5;
  const dvec3 n = solid.exit(inside).n;
  const dvec3 b = normalize(cross(n, inside)),
              t = cross(b, inside); // t: towards a larger angle of incidence
  dvec3 out, out_t, out_b;
  const dvec3 along = normalize(inside + h * t), aside = normalize(inside + h * b);
  if (!snell(inside, n, eta, out) || !snell(along, solid.exit(along).n, eta, out_t)
      || !snell(aside, solid.exit(aside).n, eta, out_b))
    return false;
  const dvec3 t_out = cross(b, out);
  result = {dot(out_t - out, t_out) / h, dot(out_b - out, b) / h};
  return true;
}

TEST(composition, of_a_smooth_exit_is_the_derivative_of_snells_law_curved_faces_included) {
  constexpr double sigma = 1e-4;
  int checked = 0;
  for (const Solid& solid : solids())
    for (double eta : etas)
      for (double theta : {10.0, 35.0, 60.0, 75.0}) {
        const Configuration c = smooth(solid, eta, theta);
        const dvec3 inside =
            f64::interfaceLobeDirection(c.wo(), {0, 0, 1}, f64::interfaceSnell(c.wo().z, eta));
        const Exit exit = solid.exit(inside);
        dvec3 out;
        Spread spread;
        // Far enough from grazing that the tables' bound at the critical angle and the least cosines are out of play.
        if (!snell(inside, exit.n, eta, out) || dot(out, exit.n) < 0.35
            || !spread_of(solid, inside, eta, spread))
          continue;
        if (std::abs(1.0 - exit.turn.x) < 0.05) continue; // a focus on the exit: the rule's bound
        if (std::max(exit.turn.x, exit.turn.y) == 8.0) continue; // exitTurn's bound
        const f64::Widening k = f64::wideningGgx(2);
        const ComposedLobe lobe = compose({inside, sigma, 1.0}, {exit.n, 0.0, 1.0 / eta, exit.turn},
                                          k, 1.0 / k.shapeRays);
        // The width at the critical angle is bounded by alpha, which is 1e-4 here: 1e-3 of sigma; differences are 1e-4.
        const double expected = sigma * std::sqrt(std::abs(spread.in_plane * spread.across));
        EXPECT_NEAR(lobe.sigma, expected, 2e-3 * sigma + 5e-3 * expected) << c.label();
        const double carried = 0.5 * sigma * (spread.in_plane + spread.across);
        EXPECT_NEAR(lobe.carried, std::clamp(carried, -expected, expected),
                    5e-3 * (sigma + std::abs(carried)))
            << c.label() << " in plane " << spread.in_plane << " across " << spread.across;
        ++checked;
      }
  EXPECT_GT(checked, 80);
}

TEST(composition, of_narrow_lobes_adds_variances) {
  // Both faces equally wide to first order: (per_width interfaceWidth)² + J sigma², in plane and across.
  for (double eta : {1.33, 1.5, 2.0, 1.0 / 1.5})
    for (double theta : {5.0, 30.0, 50.0}) {
      const Configuration c = smooth(slab(), eta, theta);
      if (eta < 1.0 && std::sin(theta * degree) > 0.9 * eta) continue;
      const dvec3 inside =
          f64::interfaceLobeDirection(c.wo(), {0, 0, 1}, f64::interfaceSnell(c.wo().z, eta));
      // Exact for one lobe; for the tables' two, which have other widths per alpha, the constants are a compromise.
      const f64::Widening k = f64::wideningGgx(1);
      const double alpha = 1e-4, per_width = 1.0 / k.shape;
      for (double sigma : {0.1 * alpha, 0.5 * alpha, alpha, 4.0 * alpha}) {
        const ComposedLobe lobe =
            compose({inside, sigma, 1.0}, {{0, 0, -1}, alpha, 1.0 / eta, {}}, k, per_width);
        const double ci = -inside.z, co = c.wo().z, bend = std::abs(eta * ci - co);
        const double facet = per_width * alpha * bend;
        const double in_plane = std::pow(facet / co, 2) + std::pow(eta * ci / co * sigma, 2),
                     across = std::pow(facet, 2) + std::pow(eta * sigma, 2);
        const double expected = std::sqrt(std::sqrt(in_plane * across));
        EXPECT_NEAR(lobe.sigma, expected, 1e-3 * expected) << c.label() << " sigma " << sigma;
      }
    }
}

TEST(composition, an_index_matched_exit_is_not_there) {
  const InnerLobe inner{normalize(dvec3(0.3, -0.2, -0.9)), 0.17, 0.6};
  for (double eta : {1.0, 1.0 + 1e-9, 1.0 - 5e-5}) {
    const ComposedLobe lobe =
        compose(inner, {{0, 0, -1}, 0.3, eta, {0.5, 0.2}}, f64::wideningGgx(2), 1.4);
    EXPECT_EQ(lobe.direction, inner.direction);
    EXPECT_EQ(lobe.sigma, inner.sigma);
    EXPECT_EQ(lobe.weight, inner.weight);
    EXPECT_EQ(lobe.carried, inner.sigma);
  }
  // Nor is there a step towards it: a face that hardly bends passes the ray's own width on.
  const ComposedLobe near = compose(inner, {{0, 0, -1}, 0.0, 1.0 / 1.001, {}}, f64::wideningGgx(1),
                                    1.0 / f64::wideningGgx(1).shapeRays);
  EXPECT_NEAR(near.sigma, inner.sigma, 0.02 * inner.sigma);
  EXPECT_LT(length(near.direction - inner.direction), 2e-3);
}

TEST(composition, a_lobe_that_does_not_meet_the_face_carries_nothing) {
  for (double z : {0.0, 0.2, 1.0}) {
    const dvec3 d = z < 1.0 ? dvec3(std::sqrt(1.0 - z * z), 0.0, z) : dvec3(0, 0, 1);
    const ComposedLobe lobe =
        compose({d, 0.2, 1.0}, {{0, 0, -1}, 0.2, 1.0 / 1.5, {}}, f64::wideningGgx(2), 1.0);
    EXPECT_EQ(lobe.weight, 0.0);
    EXPECT_EQ(lobe.direction, d);
  }
}

TEST(composition, merging_keeps_energy_mean_and_variance) {
  const ComposedLobe a{normalize(dvec3(0.02, 0.01, -1)), 0.05, 0.3, 0.02, 0.03},
      b{normalize(dvec3(-0.04, 0.02, -1)), 0.11, 0.1, 0.04, 0.01};
  const ComposedLobe m = f64::mergeLobes(a, b);
  EXPECT_DOUBLE_EQ(m.weight, 0.4);
  const dvec3 mean = 0.75 * a.direction + 0.25 * b.direction;
  EXPECT_LT(length(m.direction - normalize(mean)), rounding);
  // Per axis: the mean of the variances and half of the centres' own.
  const double apart2 = dot(a.direction - b.direction, a.direction - b.direction);
  EXPECT_NEAR(m.sigma * m.sigma,
              0.75 * 0.05 * 0.05 + 0.25 * 0.11 * 0.11 + 0.5 * 0.75 * 0.25 * apart2, rounding);
  EXPECT_NEAR(m.inner * m.carried, 0.75 * 0.02 * 0.03 + 0.25 * 0.04 * 0.01, rounding);
  // In any order.
  const ComposedLobe n = f64::mergeLobes(b, a);
  EXPECT_LT(length(m.direction - n.direction), rounding);
  EXPECT_NEAR(m.sigma, n.sigma, rounding);
  // With nothing, a lobe stays what it is; two of nothing are the first.
  ComposedLobe none = b;
  none.weight = 0.0;
  EXPECT_LT(length(f64::mergeLobes(a, none).direction - a.direction), rounding);
  EXPECT_EQ(f64::mergeLobes(a, none).sigma, a.sigma);
  EXPECT_EQ(f64::mergeLobes(none, none).weight, 0.0);
  EXPECT_LT(length(f64::mergeLobes(none, none).direction - b.direction), rounding);
  ComposedLobe opposite = a;
  opposite.direction = -a.direction;
  EXPECT_EQ(f64::mergeLobes(a, opposite).direction, a.direction);
}

// The same grid of extremes in both precisions.
template <typename Vec2, typename Vec3, typename Real>
struct Extremes {
  template <typename See, typename Compose>
  static void expect_finite(See see, Compose compose) {
    const Real cosines[] = {1, Real(1 - 1e-7), Real(0.7),  Real(0.05), Real(1e-4),
                            0, Real(-1e-6),    Real(-0.5), -1};
    const Real indices[] = {Real(0.25), Real(1 / 1.5),  Real(0.9999), Real(1 - 1e-6),
                            1,          Real(1 + 1e-6), Real(1.0002), 4};
    const Real widths[] = {0, Real(1e-6), Real(0.02), Real(0.5), 2};
    const Real alphas[] = {0, Real(1e-4), Real(0.1), 1};
    const Real turns[] = {-8, 0, 1, 2, 8};
    const Real angles[] = {Real(-1.5707964), Real(-0.3), 0, Real(0.8), Real(1.5707964)};
    long count = 0, bad = 0;
    for (Real c : cosines)
      for (Real eta : indices)
        for (Real width : widths)
          for (Real alpha : alphas)
            for (Real turn : turns)
              for (Real angle : angles)
                for (Real sigma : {Real(0), Real(1e-7), Real(0.4)}) {
                  const Vec3 d(std::sqrt(std::max(Real(1) - c * c, Real(0))), 0, c);
                  const auto view = see(d, width, alpha, eta, turn);
                  const auto lobe = compose(d, width, alpha, eta, turn, view, angle, sigma);
                  const Real length2 = lobe.direction.x * lobe.direction.x
                                       + lobe.direction.y * lobe.direction.y
                                       + lobe.direction.z * lobe.direction.z;
                  const bool fine = std::abs(length2 - 1) < Real(1e-5) && lobe.sigma >= 0
                                    && lobe.sigma < 100 && lobe.weight >= 0 && lobe.weight <= 1
                                    && std::abs(lobe.carried) <= lobe.sigma && view.alphaShape >= 0
                                    && view.alphaShape <= 1 && view.alphaEnergy <= 1
                                    && view.own >= 0 && view.own <= 1;
                  ++count;
                  if (!fine && ++bad < 5)
                    ADD_FAILURE() << "cos " << c << " eta " << eta << " width " << width
                                  << " alpha " << alpha << " turn " << turn << " angle " << angle
                                  << " sigma " << sigma << ": length² " << length2 << " sigma "
                                  << lobe.sigma << " carried " << lobe.carried;
                }
    EXPECT_EQ(bad, 0) << "of " << count;
  }
};

TEST(composition, is_finite_for_every_extreme_in_double) {
  Extremes<f64::vec2, f64::vec3, double>::expect_finite(
      [](auto d, auto width, auto alpha, auto eta, auto turn) {
        return f64::seeExit({d, width, 1.0}, true, {{0, 0, 1}, alpha, eta, {turn, turn}},
                            f64::wideningGgx(2));
      },
      [](auto d, auto width, auto alpha, auto eta, auto turn, auto view, auto angle, auto sigma) {
        return f64::composeLobe({d, width, 1.0}, view, {{0, 0, 1}, alpha, eta, {turn, turn}}, angle,
                                sigma, 1.0, 1.0);
      });
}

TEST(composition, is_finite_for_every_extreme_in_float) {
  Extremes<f32::vec2, f32::vec3, float>::expect_finite(
      [](auto d, auto width, auto alpha, auto eta, auto turn) {
        return f32::seeExit({d, width, 1.0f}, true, {{0, 0, 1}, alpha, eta, {turn, turn}},
                            f32::wideningGgx(2));
      },
      [](auto d, auto width, auto alpha, auto eta, auto turn, auto view, auto angle, auto sigma) {
        return f32::composeLobe({d, width, 1.0f}, view, {{0, 0, 1}, alpha, eta, {turn, turn}},
                                angle, sigma, 1.0f, 1.0f);
      });
}

TEST(composition, turn_of_a_sphere_is_that_of_its_curvature) {
  for (double c : {1.0, 0.6, 0.2, 0.01}) {
    const auto known = f64::sphereTurn(c),
               curved = f64::exitTurn(c, 2.0 * 0.7 * c, f64::vec2(1.0 / 0.7));
    EXPECT_NEAR(known.x, curved.x, rounding);
    EXPECT_NEAR(known.y, curved.y, rounding);
  }
  EXPECT_EQ(f64::exitTurn(0.0, 1.0, f64::vec2(1.0)).x, 8.0); // bounded at grazing
}

} // namespace
} // namespace gg::composition_test
