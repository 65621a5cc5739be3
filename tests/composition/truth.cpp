#include "composition/truth.h"

#include "glsl/f64.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace gg::composition_test {
namespace {

using namespace gg::glsl::f64;

// A frame with third axis n.
struct Frame {
  vec3 x, y, n;
  explicit Frame(const vec3& normal) : n(normal) {
    x = std::abs(n.x) < 0.9 ? vec3(1, 0, 0) : vec3(0, 1, 0);
    x = normalize(x - dot(x, n) * n);
    y = cross(n, x);
  }
  vec3 local(const vec3& v) const { return {dot(v, x), dot(v, y), dot(v, n)}; }
  vec3 world(const vec3& v) const { return v.x * x + v.y * y + v.z * n; }
};

// One facet's answer to light from wo: where it refracts it and mirrors it, and the shares of the light that this draw stands for.
struct Draw {
  vec3 through{0.0}, back{0.0};
  double passes = 0.0, returns = 0.0;
};

Draw draw(const tables::Model& model, double alpha, double eta, const vec3& wo, const vec2& u) {
  const bool ggx = model.distribution == tables::Distribution::ggx;
  const vec3 n(0, 0, 1);
  const vec3 wm = alpha == 0.0 ? n
                  : ggx        ? ggxSampleVisible(wo, vec2(alpha, alpha), u)
                               : beckmannSample(alpha, u);
  const double c = dot(wo, wm);
  Draw d;
  if (!(c > 0.0)) return d;
  d.through = refractAbout(wo, wm, eta);
  d.back = reflectAbout(wo, wm);
  const double passed = fresnelTransmittedAt(c, eta);
  const auto masked = [&](const vec3& wi) {
    if (alpha == 0.0) return 1.0;
    const Tilt i = tilt(wi), o = tilt(wo);
    if (!ggx) return beckmannG2(i, o, alpha) * c / (wo.z * wm.z);
    if (model.smith == tables::Smith::separable) return ggxG1(i, alpha);
    const double both = wi.z < 0.0 ? ggxG2Beta(i, o, alpha) : ggxG2Correlated(i, o, alpha);
    return both / ggxG1(o, alpha);
  };
  if (d.through.z < 0.0) d.passes = passed * masked(d.through);
  if (d.back.z > 0.0) d.returns = (1.0 - passed) * masked(d.back);
  return d;
}

// Roberts' R4: multiples of the powers of the root of x^5 = x + 1.
std::array<double, 4> lattice(int i) {
  constexpr double root = 1.1673039782614187;
  std::array<double, 4> u{};
  double step = 1.0;
  for (double& x : u) {
    step /= root;
    x = 0.5 + (i + 1) * step;
    x -= std::floor(x);
  }
  return u;
}

vec3 turned(const vec3& v, double degrees, bool about_x) {
  const double c = std::cos(degrees * degree), s = std::sin(degrees * degree);
  return about_x ? vec3(v.x, c * v.y - s * v.z, s * v.y + c * v.z)
                 : vec3(c * v.x + s * v.z, v.y, c * v.z - s * v.x);
}

Solid flat(std::string family, std::string name, const vec3& n) {
  return {std::move(family), std::move(name), [n](const glm::dvec3&) { return Exit{n, {}}; }};
}

double median_angle(const std::vector<Path>& paths) {
  glm::dvec3 mean(0.0);
  for (const Path& p : paths)
    mean += static_cast<double>(p.weight) * glm::dvec3(p.direction);
  if (paths.empty() || !(dot(mean, mean) > 0.0)) return 0.0;
  mean = normalize(mean);
  std::vector<std::pair<double, double>> by_angle;
  double total = 0.0;
  for (const Path& p : paths) {
    by_angle.emplace_back(std::acos(std::clamp(dot(mean, glm::dvec3(p.direction)), -1.0, 1.0)),
                          p.weight);
    total += p.weight;
  }
  std::ranges::sort(by_angle);
  double sum = 0.0;
  for (const auto& [angle, weight] : by_angle)
    if ((sum += weight) >= 0.5 * total) return angle;
  return by_angle.back().first;
}

Truth trace(const Configuration& c, int count) {
  const vec3 wo = c.wo();
  Truth truth;
  for (int i = 0; i < count; ++i) {
    const auto u = lattice(i);
    const Draw first = draw(c.model, c.alpha1, c.eta, wo, vec2(u[0], u[1]));
    if (!(first.passes > 0.0)) continue;
    truth.entered += first.passes / count;
    const vec3 inside = normalize(first.through);
    const Frame frame(-c.solid.exit(inside).n);
    const vec3 back = frame.local(-inside);
    if (!(back.z > 0.0)) continue; // meets another face
    const Draw second = draw(c.model, c.alpha2, 1.0 / c.eta, back, vec2(u[2], u[3]));
    truth.reflected += first.passes * second.returns / count;
    const double weight = first.passes * second.passes / count;
    if (!(weight > 0.0)) continue;
    truth.energy += weight;
    truth.paths.push_back(
        {glm::vec3(frame.world(normalize(second.through))), static_cast<float>(weight)});
  }
  truth.spread = median_angle(truth.paths);
  return truth;
}

} // namespace

Solid slab() {
  return flat("slab", "slab", {0, 0, -1});
}
Solid wedge(double degrees) {
  // The ray travels towards -x: a normal turned that way meets it less obliquely.
  char name[32];
  std::snprintf(name, sizeof name, "wedge %+.0f", degrees);
  return flat(degrees > 0.0 ? "wedge +" : "wedge -", name, turned({0, 0, -1}, degrees, false));
}
Solid wedge_out(double degrees) {
  char name[32];
  std::snprintf(name, sizeof name, "wedge out %.0f", degrees);
  return flat("wedge out", name, turned({0, 0, -1}, degrees, true));
}
Solid sphere() {
  return {"sphere", "sphere", [](const glm::dvec3& d) {
            const glm::dvec3 n = glm::dvec3(0, 0, 1) - 2.0 * d.z * d;
            const auto turn = sphereTurn(-d.z);
            return Exit{n, {turn.x, turn.y}};
          }};
}

Solid lens(const std::string& name, const glm::dvec3& half_axes, double depth,
           double turned_degrees) {
  const auto exit = [=](const glm::dvec3& direction) {
    // In the ellipsoid's own axes, turned about z; p runs from the entry, `depth` above the middle.
    const double c = std::cos(turned_degrees * degree), s = std::sin(turned_degrees * degree);
    const glm::dmat3 own(c, -s, 0, s, c, 0, 0, 0, 1), world = glm::transpose(own);
    const glm::dvec3 start = glm::dvec3(0, 0, depth) / half_axes,
                     step = own * direction / half_axes;
    const double a = dot(step, step), b = dot(start, step), rest = dot(start, start) - 1.0;
    const double length = (-b + std::sqrt(b * b - a * rest)) / a;
    const glm::dvec3 at = glm::dvec3(0, 0, depth) + length * (own * direction);
    const glm::dvec3 gradient = at / (half_axes * half_axes);
    const glm::dvec3 n = normalize(gradient);
    // dn/dp = (1 - n nᵀ) diag(1 / axes²) / |gradient| along the surface.
    const auto curvature = [&](const glm::dvec3& v) {
      return dot(v, v / (half_axes * half_axes)) / std::sqrt(dot(gradient, gradient));
    };
    const glm::dvec3 d = own * direction;
    const double cosine = dot(d, n);
    glm::dvec3 t = d - cosine * n;
    const double sine = std::sqrt(dot(t, t));
    t = sine > 1e-9 ? t / sine : Frame(n).x;
    const auto turn = exitTurn(cosine, length, vec2(curvature(t), curvature(cross(n, t))));
    return Exit{world * n, {turn.x, turn.y}};
  };
  return {"curved", name, exit};
}

std::string Configuration::label() const {
  char text[160];
  std::snprintf(text, sizeof text, "%s %s eta %.2f theta %.0f alpha %.2f/%.2f",
                tables::name(model).c_str(), solid.name.c_str(), eta, theta, alpha1, alpha2);
  return text;
}

glm::dvec3 Configuration::wo() const {
  return {std::sin(theta * degree), 0.0, std::cos(theta * degree)};
}

Truth brute_force(const Configuration& c, int count) {
  Truth truth = trace(c, count);
  if (truth.energy < 0.1) truth = trace(c, 4 * count);
  return truth;
}

} // namespace gg::composition_test
