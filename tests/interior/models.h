// Solids of glass, made in code or from the scenes of assets/: each of largest extent 1, about the origin.
#pragma once

#include "scene/scene.h"

#include <string>
#include <vector>

namespace gg::test {

scene::Material glass(float ior);

scene::Scene sphere(float ior);                     // radius 1/2, exact normals
scene::Scene box(const glm::vec3& size, float ior); // flat faces
scene::Scene torus(float ior);                      // tube radius 1/8 around a circle of radius 3/8
scene::Scene wineglass(float ior);                  // a bowl with walls of .012, a stem and a foot
scene::Scene hollow_box(float ior); // a cube with a cubic hole of half its size in the middle
scene::Scene prism(float ior);      // equilateral, its axis along X
// A file of assets/, every material replaced by one glass, so that all of it is one solid.
scene::Scene asset(const std::string& file, float ior);

// Looks at the origin from this direction; the object of extent 1 fills about `share` of the height.
scene::Camera camera_from(const glm::vec3& direction, float share = 0.8f);

} // namespace gg::test
