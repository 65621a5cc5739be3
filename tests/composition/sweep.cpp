// Every method against brute force, over slabs, wedges, spheres and curved exits: prints the table by method, geometry and
// nearness to the critical angle. Arguments: model (0 GGX, 1 GGX with correlated Smith, 2 Beckmann) [stride [paths [floors]]].
#include "composition/configurations.h"
#include "composition/methods.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <map>

namespace gg::composition_test {
namespace {

struct Method {
  std::string name;
  std::function<std::vector<Lookup>(const Configuration&, const Truth&)> lobes;
};

const std::vector<Method>& methods() {
  static const std::vector<Method> all = {
      {"standard practice (one interface, 1 - F)",
       [](const auto& c, const auto&) { return standard_practice(c, false); }},
      {"the same with Snell's exit direction",
       [](const auto& c, const auto&) { return standard_practice(c, true); }},
      {"the same given the exact energy",
       [](const auto& c, const auto& t) { return scaled(standard_practice(c, true), t.energy); }},
      {"tables 1x1, variances added, E1 E2",
       [](const auto& c, const auto&) { return added_variances(c, 1, false); }},
      {"tables 2x2 -> 2, variances added, E1 E2",
       [](const auto& c, const auto&) { return added_variances(c, 2, false); }},
      {"tables 2x2 -> 2, variances added, E widened",
       [](const auto& c, const auto&) { return added_variances(c, 2, true); }},
      {"composed 1x1",
       [](const auto& c, const auto&) {
         return composed(c, {1, 1, 0});
       }},
      {"**composed 2x2 -> 2**",
       [](const auto& c, const auto&) {
         return composed(c, {2, 2, 2});
       }},
      {"composed 2x2, four lobes",
       [](const auto& c, const auto&) {
         return composed(c, {2, 2, 0});
       }},
      {"composed 2x2 -> 2, curvature ignored",
       [](const auto& c, const auto&) {
         return composed(c, {2, 2, 2}, {}, false);
       }},
  };
  return all;
}

struct Result {
  const Configuration* c = nullptr;
  double energy = 0.0, entered = 0.0, reflected = 0.0, reflected_rule = 0.0;
  double past_critical = 0.0; // degrees
  std::vector<Score> scores;
  std::vector<double> energies;
};

class Mean {
public:
  void add(double x) {
    squares_ += x * x;
    worst_ = std::max(worst_, std::abs(x));
    ++count_;
  }
  double rms() const { return count_ ? std::sqrt(squares_ / count_) : 0.0; }
  double worst() const { return worst_; }
  int count() const { return count_; }

private:
  double squares_ = 0.0, worst_ = 0.0;
  int count_ = 0;
};

void print(const std::vector<Result>& results, const std::vector<std::string>& names) {
  const std::vector<std::string> families = {"slab",    "sphere",    "wedge +",
                                             "wedge -", "wedge out", "curved"};
  std::printf("\n| method | all | shape | rms dE | max dE |");
  for (const auto& f : families)
    std::printf(" %s |", f.c_str());
  std::printf(" worst |\n|---|---|---|---|---|");
  for (std::size_t i = 0; i < families.size(); ++i)
    std::printf("---|");
  std::printf("---|\n");
  for (std::size_t m = 0; m < names.size(); ++m) {
    Mean all, shape, energy;
    std::map<std::string, Mean> by;
    for (const Result& r : results) {
      energy.add(r.energies[m] - r.energy);
      if (r.energy < dark) continue;
      all.add(r.scores[m].error);
      shape.add(r.scores[m].shape);
      by[r.c->solid.family].add(r.scores[m].error);
    }
    std::printf("| %s | %.3f | %.3f | %.3f | %.3f |", names[m].c_str(), all.rms(), shape.rms(),
                energy.rms(), energy.worst());
    for (const auto& f : families)
      std::printf(" %.3f |", by[f].rms());
    std::printf(" %.2f |\n", all.worst());
  }
  const std::vector<double> edges = {-90, -25, -12, -5, 0, 5, 90};
  std::printf("\n| exit incidence less critical angle |");
  for (std::size_t b = 0; b + 1 < edges.size(); ++b)
    std::printf(" %.0f..%.0f |", edges[b], edges[b + 1]);
  std::printf("\n|---|---|---|---|---|---|---|\n");
  for (std::size_t m = 0; m < names.size(); ++m) {
    std::printf("| %s |", names[m].c_str());
    for (std::size_t b = 0; b + 1 < edges.size(); ++b) {
      Mean band;
      for (const Result& r : results)
        if (r.energy >= dark && r.past_critical >= edges[b] && r.past_critical < edges[b + 1])
          band.add(r.scores[m].error);
      std::printf(" %.3f (%d) |", band.rms(), band.count());
    }
    std::printf("\n");
  }
}

} // namespace
} // namespace gg::composition_test

int main(int argc, char** argv) {
  using namespace gg::composition_test;
  const int which = argc > 1 ? std::atoi(argv[1]) : 0;
  const int stride = argc > 2 ? std::max(std::atoi(argv[2]), 1) : 1;
  const int paths = argc > 3 ? std::max(std::atoi(argv[3]), 16) : 8192;
  const bool floors = argc > 4;
  if (which < 0 || which > 2) {
    std::fprintf(stderr, "composition_sweep: model %d is none of 0, 1, 2\n", which);
    return 1;
  }
  std::vector<Configuration> list;
  {
    const auto all = configurations(gg::tables::models[static_cast<std::size_t>(which)]);
    for (std::size_t i = 0; i < all.size(); i += static_cast<std::size_t>(stride))
      list.push_back(all[i]);
  }
  environments(128);
  std::vector<std::string> names;
  for (const Method& m : methods())
    names.push_back(m.name);
  if (floors)
    for (int k = 1; k <= 2; ++k)
      names.push_back("floor: " + std::to_string(k) + " free lobes");
  std::vector<Result> results(list.size());
  tbb::parallel_for(std::size_t{0}, list.size(), [&](std::size_t i) {
    const Configuration& c = list[i];
    Result& r = results[i];
    const Truth truth = brute_force(c, paths);
    r.c = &c;
    r.energy = truth.energy;
    r.entered = truth.entered;
    r.reflected = truth.reflected;
    r.reflected_rule = reflected_inside(c);
    r.past_critical = past_critical(c);
    const std::vector<double> seen_truth = r.energy >= dark ? seen(truth) : std::vector<double>();
    const auto judge = [&](const std::vector<Lookup>& lobes) {
      r.energies.push_back(energy_of(lobes));
      r.scores.push_back(r.energy >= dark ? score(truth, seen_truth, lobes) : Score{});
    };
    for (const Method& m : methods())
      judge(m.lobes(c, truth));
    if (floors)
      for (int k = 1; k <= 2; ++k) {
        const auto start = composed(c, k == 1 ? Shape{1, 1, 0} : Shape{2, 2, 2});
        judge(r.energy >= dark ? fitted(truth, seen_truth, start) : scaled(start, truth.energy));
      }
  });
  print(results, names);
  Mean reflected;
  for (const Result& r : results)
    reflected.add(r.reflected_rule - r.reflected);
  std::printf("\nReflected inside: rms error %.3f, largest %.3f of the incoming light (%d "
              "configurations)\n",
              reflected.rms(), reflected.worst(), reflected.count());
  std::vector<const Result*> worst;
  for (const Result& r : results)
    if (r.energy >= dark) worst.push_back(&r);
  std::ranges::sort(worst, [](const Result* a, const Result* b) {
    return a->scores[7].error > b->scores[7].error;
  });
  std::printf("\nWorst of 2x2 -> 2:\n");
  for (std::size_t i = 0; i < std::min<std::size_t>(worst.size(), 15); ++i)
    std::printf("  %s: error %.2f shape %.2f E %.3f rule %.3f past critical %.0f\n",
                worst[i]->c->label().c_str(), worst[i]->scores[7].error, worst[i]->scores[7].shape,
                worst[i]->energy, worst[i]->energies[7], worst[i]->past_critical);
  return 0;
}
