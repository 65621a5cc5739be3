#include "tables/proof.h"

#include "core/progress.h"
#include "glsl/f64.h"
#include "tables/lookup.h"

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include <cmath>
#include <numbers>

namespace gg::tables {
namespace {

namespace f64 = gg::glsl::f64;
const f64::vec3 up(0.0, 0.0, 1.0);

// Four times as many change the log error of the truth by .02 (RMS; by less than .01 on most maps).
constexpr int truth_points = 4096, prefilter_points = 2048;
constexpr int sampled_points = 32;

// What a map prefiltered for `alpha` holds in direction `d`: D(theta / 2) cos(theta) about it.
std::vector<LobeSample> prefiltered(const f64::vec3& d, double alpha) {
  std::vector<LobeSample> kernel =
      reflection_lobe(models[0], alpha, 1.0, Walk::lattice, prefilter_points);
  const f64::vec3 t =
      glm::normalize(glm::cross(d, std::abs(d.z) < 0.9 ? f64::vec3(0, 0, 1) : f64::vec3(1, 0, 0)));
  const f64::vec3 b = glm::cross(d, t);
  for (LobeSample& s : kernel) {
    s.weight = s.wi.z;
    s.wi = s.wi.x * t + s.wi.y * b + s.wi.z * d;
  }
  return kernel;
}

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
  f64::vec3 usual_direction() const {
    return side == Side::reflection
               ? f64::reflectAbout(wo(), up)
               : f64::interfaceLobeDirection(wo(), up, f64::interfaceSnell(cos_theta, eta));
  }
  double usual_alpha() const {
    return side == Side::reflection ? alpha : scaled_by_index(alpha, std::max(eta, 1.0 / eta));
  }
  std::vector<Lookup> lobes(int count) const {
    std::vector<Lookup> list;
    for (int k = 0; k < count; ++k) {
      if (side == Side::reflection) {
        const auto t = reflection_texel_at(model, k, count, cos_theta, alpha, 0.0);
        list.push_back(
            {f64::lobeDirection(f64::reflectAbout(wo(), up), up, t[0]), t[1] * alpha, t[2]});
      } else {
        const auto t = interface_lobe_at(model, k, count, cos_theta, alpha, eta);
        list.push_back({f64::interfaceLobeDirection(wo(), up, t.angle), t.sigma, t.weight});
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

Sweep study_sweep(Side side) {
  Sweep sweep{{0.02, 0.05, 0.1, 0.2, 0.35, 0.5, 0.8}, {}, {1.1, 1.33, 1.5, 2.0}};
  switch (side) {
  case Side::reflection:
    sweep.angles = {0, 30, 50, 65, 75, 85};
    break;
  case Side::entering:
    sweep.angles = {0, 30, 55, 70, 82};
    break;
  case Side::leaving:
    sweep.angles = {0, 20, 30, 38, 55};
    break;
  }
  return sweep;
}

Sweep leaving_to_grazing() {
  Sweep sweep = study_sweep(Side::leaving);
  sweep.angles = {70, 82};
  return sweep;
}

Sweep short_sweep() {
  return {{0.1, 0.35}, {0, 50, 75}, {1.5}};
}

double Scores::rms(const std::string& method) const {
  return std::sqrt(squares.at(method) / lobes);
}

double Scores::rms_pictures(const std::string& method) const {
  return std::sqrt(squares_pictures.at(method) / lobes);
}

double Scores::gain(const std::string& method) const {
  return rms("standard") / rms(method);
}

double Scores::gain_pictures(const std::string& method) const {
  return rms_pictures("standard") / rms_pictures(method);
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
        note("standard", squared_log_errors(maps, truth,
                                            radiance(maps, prefiltered(lobe.usual_direction(),
                                                                       lobe.usual_alpha()))));
        note("gaussian", squared_log_errors(
                             maps, truth,
                             std::vector<Lookup>{{lobe.usual_direction(),
                                                  mirror_width(model, lobe.usual_alpha()), 1.0}}));
        for (int k = 1; k <= lobes_of(model); ++k)
          note("lobes" + std::to_string(k), squared_log_errors(maps, truth, lobe.lobes(k)));
        note("fis32", squared_log_errors(maps, truth,
                                         radiance(maps, lobe.samples(sampled_points), {}, 0.35)));
      }
  return scores;
}

std::vector<ProofRow> prove(Progress& progress) {
  constexpr int map_size = 128, rotations = 12;
  progress.update(0, "blurring environments");
  const Training maps = held_out_maps(map_size, rotations);
  std::vector<ProofRow> rows;
  for (const Model& model : models) {
    const auto add = [&](Side side, const std::string& lobes, const Sweep& sweep) {
      progress.update(static_cast<long>(rows.size()), name(model) + ", " + lobes);
      rows.push_back({model, side, lobes, score(maps, model, side, sweep)});
    };
    add(Side::reflection, "reflection", study_sweep(Side::reflection));
    add(Side::entering, "entering", study_sweep(Side::entering));
    add(Side::leaving, "leaving", study_sweep(Side::leaving));
    add(Side::leaving, "leaving at 70, 82 degrees", leaving_to_grazing());
  }
  progress.update(static_cast<long>(rows.size()));
  return rows;
}

int proof_rows() {
  return 4 * static_cast<int>(models.size());
}

std::string proof_table(const std::vector<ProofRow>& rows) {
  std::string text = "| model | lobe | lobes | standard | 1 lobe | 2 | 3 | 4 | 32 samples | "
                     "photographs: standard | 1 lobe | 2 | 4 |\n"
                     "|---|---|---|---|---|---|---|---|---|---|---|---|---|\n";
  for (const ProofRow& row : rows) {
    const Scores& s = row.scores;
    const auto cell = [&](const std::string& method) {
      return s.squares.contains(method)
                 ? fmt::format(" {:.3f} ({:.1f}) |", s.rms(method), s.gain(method))
                 : std::string(" |");
    };
    const auto picture = [&](const std::string& method) {
      return s.squares.contains(method) ? fmt::format(" {:.3f} ({:.1f}) |", s.rms_pictures(method),
                                                      s.gain_pictures(method))
                                        : std::string(" |");
    };
    text += fmt::format("| {} | {} | {} | {:.3f} |", name(row.model), row.lobes, s.lobes,
                        s.rms("standard"));
    for (int k = 1; k <= 4; ++k)
      text += cell("lobes" + std::to_string(k));
    text += cell("fis32") + fmt::format(" {:.3f} |", s.rms_pictures("standard")) + picture("lobes1")
            + picture("lobes2") + picture("lobes4") + "\n";
  }
  return text;
}

} // namespace gg::tables
