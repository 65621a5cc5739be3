// Small scenes made in code: balls and sheets with one material each.
#pragma once

#include "scene/scene.h"

namespace gg::truth::test {

// A ball of geodesic-like rings (`rings` of them, twice as many segments), exact normals at its
// corners; texture coordinates that run through 6 x 4 pictures around it.
void add_ball(scene::Scene& scene, const scene::Material& material, glm::vec3 centre, float radius,
              int rings);
// A rectangle in the plane z = `z`, facing +Z, from -half to half in x and y.
void add_sheet(scene::Scene& scene, const scene::Material& material, float half, float z);
// A closed box about `centre`, flat-shaded.
void add_box(scene::Scene& scene, const scene::Material& material, glm::vec3 centre,
             glm::vec3 half);

scene::Material metal(float alpha);      // reflects everything (F = 1)
scene::Material glass(float alpha);      // solid, index 1.5
scene::Material thin_glass(float alpha); // a wall
scene::Material unlit(float grey);       // shines by itself, the same in every direction

// Looks along -Z from (0, 0, distance), `half_height` metres to each side.
scene::Camera orthographic(float half_height, float distance = 10.0f);

} // namespace gg::truth::test
