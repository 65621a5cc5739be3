// The environment as a light: radiance along a direction, and directions drawn where it is bright.
//
// Directions are drawn by what the radiance has above its mean, and no others are: those are found where surfaces are
// followed. For light that is gathered both ways this is the better share of the work: Karlík, Šik, Vévoda, Skřivan,
// Křivánek 2019, "MIS Compensation" [KarlikSSKM19]. So the density says nothing by itself: it is for mis_share().
#pragma once

#include "environment/map.h"
#include "truth/random.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <optional>
#include <vector>

namespace gg::truth {

class EnvironmentLight {
public:
  struct Place {
    double x = 0.0, y = 0.0; // in the map, texels from its upper left corner
  };
  struct Drawn {
    glm::dvec3 direction{0.0};
    double pdf = 0.0; // 1/sr
    Place place;
  };

  // The map is turned by `rotation` radians about +Y, counter-clockwise seen from above, and its
  // radiance multiplied by `intensity`.
  EnvironmentLight(environment::Map map, double rotation, double intensity);

  // Radiance from a unit direction: bilinear between the texels' centres, wrapped round, clamped at
  // the poles.
  glm::dvec3 radiance(const glm::dvec3& direction) const { return radiance(place_of(direction)); }
  glm::dvec3 radiance(const Place& place) const;
  // Nothing if no direction is brighter than others. Of `strata` directions each is drawn from its own part of
  // the cumulated power, so that together they find a small bright light as often as it is bright.
  std::optional<Drawn> sample(Random& random, int stratum = 0, int strata = 1) const;
  // The density with which sample() draws the direction, 1/sr.
  double pdf(const glm::dvec3& direction) const { return pdf(place_of(direction)); }
  double pdf(const Place& place) const;
  // For those who ask for both.
  Place place_of(const glm::dvec3& direction) const;
  // Over all directions and RGB.
  double mean_radiance() const { return mean_; }

private:
  double add_row(const std::vector<double>& powers);
  void note_densities(int row, double solid_angle);
  std::size_t start_of(int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(width_);
  }

  int width_, height_;
  double cosine_, sine_, intensity_;
  double mean_ = 0.0;
  // Radiance before intensity, and the density of the texel's cell, 1/sr. A cell is a texel's rectangle; inside it
  // directions are drawn uniformly over the sphere.
  std::vector<glm::vec4> texels_;
  // Cumulated power of the rows, and where to begin the search for the row of u, by the whole part of u times their
  // number [ChenAsau74].
  std::vector<double> rows_;
  std::vector<std::int32_t> first_row_;
  // The same within each row, of the cells that are drawn at all: a small part of them.
  struct Cell {
    float end = 1.0f; // cumulated
    std::int32_t column = 0;
  };
  struct Row {
    std::size_t cells = 0, firsts = 0; // where they begin
    int count = 0;                     // of the cells
    // Where searches begin: one for eight cells, so that what is drawn often, a sun, is looked up in a few lines of cache.
    int searches() const { return (count + 7) / 8; }
  };
  std::vector<Cell> cells_;
  std::vector<std::int32_t> first_cell_;
  std::vector<Row> cells_of_; // the rows
  std::vector<double> edges_; // of the rows: cosine of the polar angle
};

} // namespace gg::truth
