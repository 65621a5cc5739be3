// What is known inside triangles, as values at their vertices.
#pragma once

#include "scene/scene.h"

#include <glm/glm.hpp>

#include <array>
#include <vector>

namespace gg::needs {

// Values at the vertices whose interpolation is nearest to `inside`, least squares by area [Kavan, Bargteil, Sloan 2011]: three
// values for each triangle, at the points two thirds of the way from its middle to each corner (barycentric 2/3, 1/6, 1/6). Vertices
// at one point with one normal get one value; those of no triangle with an area, 0. May pass the range of `inside`, where triangles
// are large.
std::vector<float> fitted_at_vertices(const std::vector<glm::vec3>& points,
                                      const std::vector<glm::vec3>& normals,
                                      const scene::Indices& corners,
                                      const std::vector<std::array<float, 3>>& inside);

} // namespace gg::needs
