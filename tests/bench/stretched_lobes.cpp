// The reflection lobe of brushed surfaces (GGX of two widths) as lookups of a Gaussian-prefiltered environment, against brute
// force on environments that no fit has seen: RMS of ln of the ratio, as the other tables' proof (app/tables/proof.h), over four
// angles of view and four azimuths. A row for each pair of widths: one lookup of an isotropic lobe; the usual approximation; so many parts
// (shaders/environment/stretched_lobe.glsl) of two lookups each; as many parts as the program takes, once and in 16 samples;
// and how far the albedo is off at worst.
#include "glsl/f64.h"
#include "tables/held_out.h"
#include "tables/lookup.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>

namespace {

using namespace gg;
namespace f64 = glsl::f64;
using tables::Lookup;

constexpr tables::Model model{};
constexpr int reference_samples = 4096; // noise below 1 % of what is measured here

glm::dvec3 direction(double polar, double azimuth) {
  return {std::sin(polar) * std::cos(azimuth), std::sin(polar) * std::sin(azimuth),
          std::cos(polar)};
}

// Visible normals on a lattice [Heitz18]; what is lost to shadowing is in the weights.
std::vector<tables::LobeSample> brute_force(const glm::dvec3& wo, const glm::dvec2& alpha,
                                            double& albedo) {
  std::vector<tables::LobeSample> lobe;
  albedo = 0.0;
  for (int i = 0; i < reference_samples; ++i) {
    const glm::dvec2 u((i + 0.5) / reference_samples, std::fmod(0.5 + i * 0.6180339887498949, 1.0));
    const glm::dvec3 m = f64::ggxSampleVisible(wo, alpha, u);
    const glm::dvec3 wi = f64::reflectAbout(wo, m);
    if (!(wi.z > 0.0)) continue;
    const f64::Facet facet = f64::reflectionFacet(wi, wo, glm::dvec3(0, 0, 1), 0.0);
    const double pdf =
        f64::reflectionPdf(facet, f64::ggxAnisoPdfVisible(facet, wi + wo, wo, alpha));
    const double weight = f64::ggxAnisoG1(wi, alpha);
    albedo += weight / reference_samples;
    lobe.push_back({wi, glm::dot(wo, m), weight, std::max(pdf * reference_samples, 1e-3)});
  }
  return lobe;
}

void add_lobe(std::vector<Lookup>& lookups, const glm::dvec3& wo, const glm::dvec3& n, double alpha,
              int lobes, double weight) {
  const double c = std::clamp(glm::dot(wo, n), 0.0, 1.0);
  for (int t = 0; t < lobes; ++t) {
    const auto texel = tables::reflection_texel_at(model, t, lobes, c, alpha, 0.0);
    lookups.push_back({f64::lobeDirection(f64::reflectAbout(wo, n), n, texel[0]), texel[1] * alpha,
                       texel[2] * weight});
  }
}

std::vector<Lookup> parts(const glm::dvec3& wo, const glm::dvec2& alpha, int count, int lobes,
                          double shift = 0.0, double sharpness = 1.0) {
  std::vector<Lookup> lookups;
  double sum = 0.0;
  for (int k = 0; k < count; ++k) {
    const f64::StretchedPart p = f64::stretchedPart(wo, alpha, k, count, shift, sharpness);
    if (!(p.weight > 0.0)) continue;
    add_lobe(lookups, wo, p.n, p.alpha, lobes, p.weight);
    sum += p.weight;
  }
  for (Lookup& l : lookups)
    l.weight /= sum;
  return lookups;
}

std::vector<Lookup> in_samples(const glm::dvec3& wo, const glm::dvec2& alpha, int count, int lobes,
                               int samples) {
  std::vector<Lookup> all;
  for (int i = 0; i < samples; ++i)
    for (Lookup l :
         parts(wo, alpha, count, lobes, (i + 0.5) / samples - 0.5, 1.0 / std::sqrt(samples))) {
      l.weight /= samples;
      all.push_back(l);
    }
  return all;
}

// The bent normal of the Khronos viewer, Filament and three.js.
std::vector<Lookup> standard(const glm::dvec3& wo, const glm::dvec2& alpha) {
  const glm::dvec3 n(0, 0, 1), x(1, 0, 0);
  const double strength = std::sqrt((alpha.x - alpha.y) / (1.0 - alpha.y));
  const double keep = std::pow(1.0 - strength * std::sqrt(alpha.y), 4.0);
  glm::dvec3 bent = glm::cross(glm::cross(x, wo), x);
  bent = glm::normalize(glm::mix(glm::normalize(bent), n, keep));
  const auto texel = tables::reflection_texel_at(model, 0, 1, 1.0, alpha.y, 0.0);
  return {{f64::reflectAbout(wo, bent), texel[1] * alpha.y, 1.0}};
}

} // namespace

int main() {
  const tables::Training maps = tables::held_out_maps(64, 2);
  fmt::print(
      "| alpha along, across | 1 lookup | standard | 2 parts | 4 | 8 | 16 | the program's | in "
      "16 samples | albedo off by |\n"
      "|---|---|---|---|---|---|---|---|---|---|\n");
  for (const double across : {0.02, 0.05, 0.1, 0.25, 0.5})
    for (const double along : {0.1, 0.2, 0.4, 0.6, 0.8, 1.0}) {
      if (along <= across) continue;
      const glm::dvec2 alpha(along, across);
      std::array<double, 8> squares{};
      double worst_albedo = 0.0;
      int lobes = 0;
      const int own = glsl::f64::stretchedParts(alpha);
      for (const double polar : {0.0, 30.0, 55.0, 75.0})
        for (const double azimuth : {0.0, 30.0, 60.0, 90.0}) {
          if (polar == 0.0 && azimuth > 0.0) continue;
          const double degree = std::numbers::pi / 180.0;
          const glm::dvec3 wo = direction(polar * degree, azimuth * degree);
          double albedo = 0.0;
          const auto truth = tables::radiance(maps, brute_force(wo, alpha, albedo));
          std::vector<Lookup> one;
          add_lobe(one, wo, glm::dvec3(0, 0, 1), std::sqrt(along * across), 1, 1.0);
          const std::array<std::vector<Lookup>, 8> ways = {one,
                                                           standard(wo, alpha),
                                                           parts(wo, alpha, 2, 2),
                                                           parts(wo, alpha, 4, 2),
                                                           parts(wo, alpha, 8, 2),
                                                           parts(wo, alpha, 16, 2),
                                                           parts(wo, alpha, own, 2),
                                                           in_samples(wo, alpha, own, 2, 16)};
          for (std::size_t w = 0; w < ways.size(); ++w)
            squares[w] += std::pow(tables::log_error(maps, truth, ways[w]), 2.0);
          const double width = f64::stretchedEnergyAlpha(wo, alpha);
          const double found = tables::reflection_energy_at(model, wo.z, width).albedo;
          worst_albedo = std::max(worst_albedo, std::abs(found - albedo));
          ++lobes;
        }
      fmt::print("| {}, {} |", along, across);
      for (std::size_t w = 0; w < squares.size(); ++w)
        fmt::print(" {:.3f}{} |", std::sqrt(squares[w] / lobes),
                   w == 6 ? fmt::format(" ({})", own) : "");
      fmt::print(" {:.3f} |\n", worst_albedo);
      std::fflush(stdout);
    }
  return 0;
}
