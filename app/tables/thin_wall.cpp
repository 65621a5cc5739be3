#include "tables/thin_wall.h"

#include "glsl/f64.h"
#include "tables/facets.h"

#include <tbb/parallel_for.h>

#include <cmath>
#include <numbers>

namespace gg::tables {
namespace {

namespace glsl = gg::glsl::f64;
using glsl::vec3;

constexpr int nx = glsl::THIN_WALL_COSINES, ny = glsl::THIN_WALL_ALPHAS,
              nz = glsl::THIN_WALL_SLICES;
constexpr int paths = 3072;

// What is left inside when a path is given up, and the most faces that it may meet: nearly smooth glass at grazing angles
// passes little at each.
constexpr double least_left = 1e-4;
constexpr int most_faces = 64;

// Additive recurrences by square roots of primes, two for each face that a path meets; after eight faces they repeat,
// shifted by their order.
double sequence(int path, int dimension) {
  static const double roots[] = {2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37, 41, 43, 47, 53};
  const int lap = dimension / 16;
  const double at = (path + 0.5) * std::sqrt(roots[dimension % 16]) + lap * std::numbers::phi;
  return at - std::floor(at);
}

} // namespace

WallLight through_wall(const Model& model, double alpha, double cos_theta, double eta, int count) {
  WallLight light;
  for (int path = 0; path < count; ++path) {
    vec3 wo(std::sqrt((1.0 - cos_theta) * (1.0 + cos_theta)), 0.0, cos_theta);
    double left = 1.0 / count;
    // `wo` is always on the side of +z of the face that is met next; `mirrored`: in a frame whose z points down the wall.
    bool inside = false, mirrored = false;
    for (int face = 0; face < most_faces && left * count > least_left; ++face) {
      const double index = inside ? 1.0 / eta : eta;
      const vec3 wm =
          draw_facet(model, alpha, wo, sequence(path, 2 * face), sequence(path, 2 * face + 1));
      const double facing = glsl::dot(wo, wm);
      if (!(facing > 0.0)) break;
      const double through = glsl::fresnelTransmitted(facing, glsl::fresnelG(facing, index), index);
      const vec3 on = through > 0.0 ? glsl::refractAbout(wo, wm, index) : vec3(0.0);
      const vec3 back = glsl::reflectAbout(wo, wm);
      const double gone = on.z < 0.0 ? left * through * passed(model, alpha, wo, on, wm) : 0.0;
      const double kept =
          back.z > 0.0 ? left * (1.0 - through) * passed(model, alpha, wo, back, wm) : 0.0;
      if (!inside) { // the first face: what it reflects is done, what it passes goes on to the second
        light.reflected_first += kept;
        left = gone;
        if (!(left > 0.0)) break;
        wo = -on;
        inside = true;
        continue;
      }
      if (gone > 0.0 && mirrored) {
        light.reflected_later += gone;
        light.returned.push_back({vec3(on.x, on.y, -on.z), facing, gone, 0.0});
      }
      if (gone > 0.0 && !mirrored) {
        light.transmitted += gone;
        light.directions.push_back({on, facing, gone, 0.0});
      }
      left = kept;
      if (!(left > 0.0)) break;
      // Up to the other face: seen from there, upside down.
      wo = vec3(-back.x, -back.y, back.z);
      mirrored = !mirrored;
    }
  }
  const LobeShape shape = shape_of(light.directions);
  // A lobe without width is a direction: some area, the same for all its samples.
  const double area = std::numbers::pi * std::pow(1.5 * std::max(shape.width, 1e-9), 2.0);
  for (LobeSample& s : light.directions)
    s.density = static_cast<double>(light.directions.size()) / area;
  return light;
}

int thin_wall_grid_steps() {
  return ny;
}

int thin_wall_lobe_steps() {
  return grid_steps({0, ny, 0, 1, {}});
}

WallGrid thin_wall_grid(const FitViews& views, const Model& model, const Step& step) {
  WallGrid wall{{model, 0, std::vector<float>(std::size_t{4} * nx * ny * nz)},
                {nx, ny, nz, nz, {}}};
  wall.grid.cells.resize(std::size_t{nx} * ny * nz);
  for (int y = 0; y < ny; ++y) {
    tbb::parallel_for(0, nx * nz, [&](int i) {
      const int x = i % nx, slice = i / nx;
      const WallAxes at = thin_wall_axes(x, y, slice);
      const std::size_t index = wall.grid.index(x, y, slice);
      WallLight light;
      if (at.alpha > 0.0) {
        light = through_wall(model, at.alpha, at.cos_theta, at.eta, paths);
        std::vector<double> weights;
        for (const LobeSample& s : light.directions)
          weights.push_back(s.weight);
        if (!weights.empty()) {
          GridCell& cell = wall.grid.cells[index];
          cell.empty = false;
          cell.centre = std::acos(at.cos_theta);
          cell.unit = glsl::thinWallWidth(at.cos_theta, at.alpha, at.eta);
          cell.target = fit_target(views, light.directions, weights, at.cos_theta == 1.0);
        }
      } else { // what comes back: (1 - F)² F (1 + F² + F⁴ + ...)
        const double f = glsl::fresnelDielectricAt(at.cos_theta, at.eta);
        light.transmitted = (1.0 - f) / (1.0 + f);
        light.reflected_first = f;
        light.reflected_later = f * light.transmitted;
      }
      wall.energy.texels[4 * index] = static_cast<float>(light.transmitted);
      wall.energy.texels[4 * index + 1] = static_cast<float>(light.reflected_first);
      wall.energy.texels[4 * index + 2] = static_cast<float>(light.reflected_later);
    });
    step();
  }
  return wall;
}

ThinWallTable make_thin_wall_lobes(const Model& model, const FitViews& views, const Grid& grid,
                                   int lobes, const Step& step) {
  return {model, lobes, offsets_and_widths(grid, fit_grid(views, grid, lobes, step), lobes)};
}

} // namespace gg::tables
