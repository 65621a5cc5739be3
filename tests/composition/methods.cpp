#include "composition/methods.h"

#include "tables/lookup.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace gg::composition_test {
namespace {

using f64::ComposedLobe;
using f64::ExitSurface;
using f64::ExitView;
using f64::InnerLobe;
using f64::Widening;
using glm::dvec3;

const dvec3 up(0, 0, 1);

InnerLobe inner_lobe(const Configuration& c, int lobe, int lobes) {
  const dvec3 wo = c.wo();
  const double energy = tables::interface_energy_at(c.model, wo.z, c.alpha1, c.eta).transmitted;
  const auto read = tables::interface_lobe_at(c.model, lobe, lobes, wo.z, c.alpha1, c.eta);
  return {f64::interfaceLobeDirection(wo, up, read.angle), read.sigma, read.weight * energy};
}

ExitSurface exit_of(const Configuration& c, const dvec3& direction, bool curved = true) {
  const Exit exit = c.solid.exit(direction);
  return {exit.n, c.alpha2, 1.0 / c.eta, curved ? exit.turn : glm::dvec2(0.0)};
}

double passed(const Configuration& c, const ExitView& view, const ExitSurface& s) {
  return tables::interface_energy_at(c.model, std::max(view.cosTheta, 0.0), view.alphaEnergy, s.eta)
      .transmitted;
}

Lookup lookup_of(const ComposedLobe& lobe) {
  return {lobe.direction, lobe.sigma, lobe.weight};
}

// Snell's law at the face with outward normal n; where that is total reflection, along the face.
dvec3 snell(const dvec3& d, const dvec3& n, double ratio) {
  const double cosine = dot(d, n);
  const dvec3 across = ratio * (d - cosine * n);
  const double rest = 1.0 - dot(across, across);
  return rest > 0.0 ? across + std::sqrt(rest) * n : normalize(across);
}

// Sigma of the reflection lobe at normal incidence, what environment maps are blurred by for a given roughness.
double mirror_width(const tables::Model& model, double alpha) {
  return tables::reflection_texel_at(model, 0, 1, 1.0, alpha, 0.0)[1] * alpha;
}

} // namespace

Widening widening(const tables::Model& model, int lobes) {
  return model.distribution == tables::Distribution::beckmann ? f64::wideningBeckmann(lobes)
                                                              : f64::wideningGgx(lobes);
}

std::vector<Lookup> composed(const Configuration& c, const Shape& shape,
                             const std::optional<Widening>& constants, bool curved) {
  const Widening k = constants ? *constants : widening(c.model, shape.first);
  std::vector<ComposedLobe> lobes;
  for (int i = 0; i < shape.first; ++i) {
    const InnerLobe inner = inner_lobe(c, i, shape.first);
    const ExitSurface s = exit_of(c, inner.direction, curved);
    const ExitView view = f64::seeExit(inner, i == 0, s, k);
    const double energy = passed(c, view, s);
    const auto through = [&](int j) {
      const auto read = tables::interface_lobe_at(
          c.model, j, shape.second, std::max(view.cosTheta, 0.0), view.alphaShape, s.eta);
      return f64::composeLobe(inner, view, s, read.angle, read.sigma, read.weight, energy);
    };
    if (shape.second == 2) {
      const auto pair = f64::composedPair(through(0), through(1), view);
      lobes.insert(lobes.end(), {pair.core, pair.rest});
    } else {
      lobes.push_back(through(0));
    }
  }
  if (shape.kept == 2 && lobes.size() == 4) {
    const auto pair = f64::mergePairs({lobes[0], lobes[1]}, {lobes[2], lobes[3]});
    lobes = {pair.core, pair.rest};
  }
  std::vector<Lookup> result;
  for (const ComposedLobe& lobe : lobes)
    result.push_back(lookup_of(lobe));
  return result;
}

double reflected_inside(const Configuration& c) {
  double sum = 0.0;
  for (int i = 0; i < 2; ++i) {
    const InnerLobe inner = inner_lobe(c, i, 2);
    const ExitSurface s = exit_of(c, inner.direction);
    const ExitView view = f64::seeExit(inner, i == 0, s, widening(c.model, 2));
    if (!(view.cosTheta > 0.0)) continue;
    const auto own = tables::interface_energy_at(c.model, view.cosTheta, s.alpha, s.eta);
    sum += inner.weight * std::max(own.reflected + own.transmitted - passed(c, view, s), 0.0);
  }
  return sum;
}

std::vector<Lookup> standard_practice(const Configuration& c, bool leaves) {
  const dvec3 wo = c.wo(), inside = f64::refractAbout(wo, up, c.eta);
  const double roughness = std::sqrt(c.alpha1) * std::clamp(2.0 * c.eta - 2.0, 0.0, 1.0);
  const double alpha = roughness * roughness;
  Lookup lobe;
  lobe.direction = leaves ? snell(inside, exit_of(c, inside).n, c.eta) : inside;
  lobe.sigma = mirror_width(c.model, alpha);
  lobe.weight = f64::fresnelTransmittedAt(wo.z, c.eta);
  return {lobe};
}

std::vector<Lookup> added_variances(const Configuration& c, int lobes, bool widened) {
  const Widening k = widening(c.model, lobes);
  std::vector<ComposedLobe> sums;
  for (int i = 0; i < lobes; ++i) {
    const InnerLobe inner = inner_lobe(c, i, lobes);
    ExitSurface s = exit_of(c, inner.direction);
    ExitView view = f64::seeExit(inner, i == 0, s, k);
    if (!(view.cosTheta > 0.0)) continue;
    const double energy = tables::interface_energy_at(c.model, view.cosTheta,
                                                      widened ? view.alphaEnergy : s.alpha, s.eta)
                              .transmitted;
    const dvec3 along = inner.direction - view.cosTheta * s.n;
    const double sine = std::sqrt(dot(along, along));
    const dvec3 t = along / std::max(sine, 1e-12);
    for (int j = 0; j < lobes; ++j) {
      const auto read = tables::interface_lobe_at(c.model, j, lobes, view.cosTheta, s.alpha, s.eta);
      // Beyond the critical angle the derivative has no end: it stops where the light outside is 0.1 above the face.
      const double cos_out = std::max(std::cos(read.angle), 0.1);
      const double in_plane = c.eta * view.cosTheta / cos_out * (1.0 - s.turn.x) + s.turn.x,
                   across = c.eta + (cos_out - c.eta * view.cosTheta) * s.turn.y;
      const double own = read.sigma * read.sigma, rays = inner.sigma * inner.sigma;
      ComposedLobe lobe;
      lobe.direction = std::sin(read.angle) * t + std::cos(read.angle) * s.n;
      lobe.sigma =
          std::sqrt(std::sqrt((own + in_plane * in_plane * rays) * (own + across * across * rays)));
      lobe.weight = inner.weight * read.weight * energy;
      lobe.inner = lobe.carried = 0.0;
      sums.push_back(lobe);
    }
  }
  while (static_cast<int>(sums.size()) > lobes) {
    const ComposedLobe last = sums.back();
    sums.pop_back();
    sums.back() = f64::mergeLobes(sums.back(), last);
  }
  std::vector<Lookup> result;
  for (const ComposedLobe& lobe : sums)
    result.push_back(lookup_of(lobe));
  if (result.empty())
    result.push_back({c.solid.exit(f64::refractAbout(c.wo(), up, c.eta)).n, 0.5, 0.0});
  return result;
}

std::vector<Lookup> scaled(std::vector<Lookup> lobes, double energy) {
  const double factor = energy / std::max(energy_of(lobes), 1e-6);
  for (Lookup& lobe : lobes)
    lobe.weight *= factor;
  return lobes;
}

} // namespace gg::composition_test
