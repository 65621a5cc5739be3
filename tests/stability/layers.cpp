// Layers in their hard cases: brushing, thin films, clear coats. Writes inputs, and what the snippets make of them in float32 and in
// double, for layers.py:  stability_layers OUT.csv
#include "glsl/f32.h"
#include "glsl/f64.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <functional>
#include <random>

namespace {

namespace f32 = gg::glsl::f32;
namespace f64 = gg::glsl::f64;

constexpr int per_class = 500;
using Inputs = std::array<float, 8>;

std::mt19937 random_bits(20);

double uniform(double low, double high) {
  return low + (high - low) * (static_cast<double>(random_bits()) / 4294967296.0);
}
double spread(double low, double high) { // evenly over its logarithm
  return low * std::pow(high / low, uniform(0.0, 1.0));
}

glm::dvec3 direction(double cosine) {
  const double sine = std::sqrt(1.0 - cosine * cosine), azimuth = uniform(0.0, 6.283185307179586);
  return {sine * std::cos(azimuth), sine * std::sin(azimuth), cosine};
}

Inputs pair(const glm::dvec3& wi, const glm::dvec3& wo, double along, double across) {
  const auto f = [](double v) { return static_cast<float>(v); };
  return {f(wi.x), f(wi.y), f(wi.z), f(wo.x), f(wo.y), f(wo.z), f(along), f(across)};
}

// A facet whose slopes are of the order of the widths reflects wo.
Inputs on_lobe(double cosine, double across) {
  const double along = uniform(0.3, 1.0);
  while (true) {
    const glm::dvec3 wo = direction(cosine);
    const glm::dvec3 m =
        glm::normalize(glm::dvec3(along * uniform(-1.5, 1.5), across * uniform(-1.5, 1.5), 1.0));
    const glm::dvec3 wi = 2.0 * glm::dot(wo, m) * m - wo;
    if (glm::dot(wo, m) > 0.0 && wi.z > 1e-4) return pair(wi, wo, along, across);
  }
}

Inputs film(double cosine, double thickness, double f0) {
  return {static_cast<float>(cosine), static_cast<float>(uniform(1.1, 2.2)),
          static_cast<float>(thickness), static_cast<float>(f0)};
}

struct Class {
  const char* name;
  const char* kind;
  std::function<Inputs()> draw;
};

const Class classes[] = {
    {"brushed", "brushing", [] { return on_lobe(uniform(0.1, 1.0), uniform(0.05, 0.3)); }},
    {"brushed_strongly", "brushing", [] { return on_lobe(uniform(0.1, 1.0), spread(1e-3, 1e-2)); }},
    {"brushed_grazing", "brushing", [] { return on_lobe(spread(1e-4, 1e-2), spread(1e-2, 0.3)); }},
    {"brushed_off_lobe", "brushing",
     [] {
       return pair(direction(uniform(0.05, 1.0)), direction(uniform(0.05, 1.0)), uniform(0.3, 1.0),
                   spread(1e-3, 1e-2));
     }},
    {"film", "film", [] { return film(uniform(0.1, 1.0), uniform(100.0, 800.0), 0.04); }},
    {"film_grazing", "film", [] { return film(spread(1e-6, 1e-2), uniform(100.0, 800.0), 0.04); }},
    {"film_on_mirror", "film",
     [] { return film(uniform(0.1, 1.0), uniform(100.0, 800.0), uniform(0.9, 0.999)); }},
    {"film_thick", "film", [] { return film(uniform(0.1, 1.0), spread(800.0, 5000.0), 0.04); }},
    {"coat", "coat",
     [] {
       return Inputs{static_cast<float>(uniform(0.01, 1.0)), 1.0f};
     }},
    {"coat_grazing", "coat",
     [] {
       return Inputs{static_cast<float>(spread(1e-7, 1e-2)), 1.0f};
     }},
    {"coat_passes", "passes",
     [] {
       return Inputs{static_cast<float>(uniform(0.01, 1.0)), 1.0f};
     }},
    {"coat_passes_grazing", "passes",
     [] {
       return Inputs{static_cast<float>(spread(1e-7, 1e-2)), 1.0f};
     }},
};

double single(const std::string& kind, const Inputs& v) {
  if (kind == "brushing") {
    const f32::vec3 wi(v[0], v[1], v[2]), wo(v[3], v[4], v[5]);
    const f32::vec2 alpha(v[6], v[7]);
    return static_cast<double>(f32::ggxAnisoD(wi + wo, alpha) * f32::ggxAnisoV(wi, wo, alpha));
  }
  if (kind == "film")
    return static_cast<double>(
        f32::filmFresnel(v[0], v[1], v[2], f32::vec3(f32::filmBaseIor(v[3]))).y);
  if (kind == "passes") return static_cast<double>(f32::coatPasses(v[1], v[0]));
  return static_cast<double>(f32::coatShare(v[1], v[0]));
}

double exact(const std::string& kind, const Inputs& v) {
  const auto d = [&](std::size_t i) { return static_cast<double>(v[i]); };
  if (kind == "brushing") {
    const glm::dvec3 wi(d(0), d(1), d(2)), wo(d(3), d(4), d(5));
    const glm::dvec2 alpha(d(6), d(7));
    return f64::ggxAnisoD(wi + wo, alpha) * f64::ggxAnisoV(wi, wo, alpha);
  }
  if (kind == "film")
    return f64::filmFresnel(d(0), d(1), d(2), glm::dvec3(f64::filmBaseIor(d(3)))).y;
  if (kind == "passes") return f64::coatPasses(d(1), d(0));
  return f64::coatShare(d(1), d(0));
}

} // namespace

int main(int count, char** words) {
  std::FILE* out = count == 2 ? std::fopen(words[1], "w") : nullptr;
  if (!out) return 2;
  fmt::print(out, "class,kind,i0,i1,i2,i3,i4,i5,i6,i7,float,double\n");
  for (const Class& c : classes)
    for (int i = 0; i < per_class; ++i) {
      const Inputs v = c.draw();
      fmt::print(out, "{},{}", c.name, c.kind);
      for (const float x : v)
        fmt::print(out, ",{:.17g}", static_cast<double>(x));
      fmt::print(out, ",{:.17g},{:.17g}\n", single(c.kind, v), exact(c.kind, v));
    }
  return std::fclose(out) == 0 ? 0 : 5;
}
