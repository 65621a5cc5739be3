#include "composition/configurations.h"

#include "glsl/f64.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <random>

namespace gg::composition_test {

std::vector<Configuration> configurations(const tables::Model& model) {
  struct Family {
    std::vector<Solid> solids;
    int draws;
  };
  std::vector<Family> families(6);
  families[0] = {{slab()}, 90};
  families[1] = {{sphere()}, 90};
  families[2].draws = families[3].draws = 80;
  families[4].draws = 112;
  for (double angle : {5.0, 15.0, 30.0, 45.0}) {
    families[2].solids.push_back(wedge(angle));
    families[3].solids.push_back(wedge(-angle));
    families[4].solids.push_back(wedge_out(angle));
  }
  families[5] = {{lens("cylinder across", {1.0, 50.0, 1.0}, 0.8),
                  lens("cylinder along", {50.0, 1.0, 1.0}, 0.8),
                  lens("cylinder askew", {50.0, 1.0, 1.0}, 0.8, 45.0),
                  lens("ellipsoid", {1.5, 1.0, 1.2}, 0.6),
                  lens("shallow lens", {3.0, 3.0, 2.0}, 0.2)},
                 88};
  const double etas[] = {1.33, 1.5, 2.0}, thetas[] = {0.0, 30.0, 50.0, 65.0, 80.0},
               alphas[] = {0.0, 0.02, 0.1, 0.25, 0.5};
  std::mt19937 bits(7);
  const auto pick = [&](const auto& from) { return from[bits() % std::size(from)]; };
  std::vector<Configuration> list;
  for (const Family& family : families)
    for (int i = 0; i < family.draws; ++i) {
      Configuration c;
      c.solid = pick(family.solids);
      c.model = model;
      c.eta = pick(etas);
      c.theta = pick(thetas);
      do {
        c.alpha1 = pick(alphas);
        c.alpha2 = pick(alphas);
      } while (c.alpha1 == 0.0 && c.alpha2 == 0.0);
      list.push_back(c);
    }
  return list;
}

double past_critical(const Configuration& c) {
  namespace f64 = gg::glsl::f64;
  const glm::dvec3 inside = f64::refractAbout(c.wo(), f64::vec3(0, 0, 1), c.eta);
  const double incidence = std::acos(std::clamp(dot(inside, c.solid.exit(inside).n), -1.0, 1.0));
  return (incidence - std::asin(std::min(1.0 / c.eta, 1.0))) / degree;
}

} // namespace gg::composition_test
