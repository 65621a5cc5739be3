#include "tables/proof.h"

#include "glsl/f64.h"
#include "tables/lookup.h"

#include <cmath>
#include <numbers>

namespace gg::tables {
namespace {

namespace f64 = gg::glsl::f64;
const f64::vec3 up(0.0, 0.0, 1.0);

constexpr int truth_points = 1536;
constexpr int sampled_points = 32;

double mirror_width(const Model& model, double alpha) {
  return reflection_texel_at(model, 0, 1, 1.0, alpha, 0.0)[1] * alpha;
}

// roughness · clamp(2 ior - 2, 0, 1), squared: an index of 1 is clear whatever the roughness.
double scaled_by_index(double alpha, double index) {
  const double roughness = std::sqrt(alpha) * std::clamp(2.0 * index - 2.0, 0.0, 1.0);
  return roughness * roughness;
}

struct Lobe {
  Side side;
  Model model;
  double alpha, cos_theta, eta; // eta of the far side over the near one

  f64::vec3 wo() const {
    return {std::sqrt((1.0 - cos_theta) * (1.0 + cos_theta)), 0.0, cos_theta};
  }
  std::vector<LobeSample> samples(int count) const {
    return side == Side::reflection ? reflection_lobe(model, alpha, cos_theta, Walk::lattice, count)
                                    : transmission_lobe(model, alpha, cos_theta, eta, count);
  }
  Lookup standard() const {
    if (side == Side::reflection)
      return {f64::reflectAbout(wo(), up), mirror_width(model, alpha), 1.0};
    const double scaled = scaled_by_index(alpha, std::max(eta, 1.0 / eta));
    return {f64::interfaceTapDirection(wo(), up, f64::interfaceSnell(cos_theta, eta)),
            mirror_width(model, scaled), 1.0};
  }
  std::vector<Lookup> taps(int count) const {
    std::vector<Lookup> list;
    for (int k = 0; k < count; ++k) {
      if (side == Side::reflection) {
        const auto t = reflection_texel_at(model, k, count, cos_theta, alpha, 0.0);
        list.push_back(
            {f64::lobeDirection(f64::reflectAbout(wo(), up), up, t[0]), t[1] * alpha, t[2]});
      } else {
        const auto t = interface_tap_at(model, k, count, cos_theta, alpha, eta);
        list.push_back({f64::interfaceTapDirection(wo(), up, t.angle), t.sigma, t.weight});
      }
    }
    return list;
  }
};

double mean(const std::vector<double>& values, std::size_t count) {
  double sum = 0.0;
  for (std::size_t i = 0; i < count; ++i)
    sum += values[i];
  return sum / static_cast<double>(count);
}

} // namespace

Sweep full_sweep() {
  return {{0.05, 0.1, 0.2, 0.35, 0.5, 0.8}, {0, 30, 50, 65, 75, 82}, {1.1, 1.33, 1.5, 2.0}};
}

Sweep short_sweep() {
  return {{0.1, 0.35}, {0, 50, 75}, {1.5}};
}

double Scores::rms(const std::string& method) const {
  return std::sqrt(squares.at(method) / lobes);
}

double Scores::gain(const std::string& method) const {
  return rms("standard") / rms(method);
}

Scores score(const Training& maps, const Model& model, Side side, const Sweep& sweep) {
  const std::vector<double> one{1.0};
  Scores scores;
  const std::size_t views = maps.views().size();
  const auto pictures = static_cast<std::size_t>(picture_views(maps));
  for (double index : side == Side::reflection ? one : sweep.indices)
    for (double alpha : sweep.alphas)
      for (double angle : sweep.angles) {
        const Lobe lobe{side, model, alpha, std::cos(angle * std::numbers::pi / 180.0),
                        side == Side::leaving ? 1.0 / index : index};
        const std::vector<LobeSample> samples = lobe.samples(truth_points);
        double energy = 0.0;
        for (const LobeSample& s : samples)
          energy += s.weight;
        if (energy < Sweep::least_energy) continue;
        ++scores.lobes;
        const std::vector<double> truth = radiance(maps, samples);
        const auto note = [&](const std::string& method, const std::vector<double>& squares) {
          scores.squares[method] += mean(squares, views);
          if (pictures > 0) scores.squares_pictures[method] += mean(squares, pictures);
        };
        note("standard", squared_log_errors(maps, truth, {lobe.standard()}));
        for (int k = 1; k <= taps_of(model); ++k)
          note("taps" + std::to_string(k), squared_log_errors(maps, truth, lobe.taps(k)));
        note("fis32", squared_log_errors(maps, truth,
                                         radiance(maps, lobe.samples(sampled_points), {}, 0.35)));
      }
  return scores;
}

} // namespace gg::tables
