// Scenes made in code, of shapes whose every point is known.
#pragma once

#include "scene/scene.h"

namespace gg::test {

// A ball of radius 1 at the origin with exact normals, texture coordinates and tangents. 96 x 192
// quads: the facets stay within 3e-4 of the sphere.
scene::Scene ball(const scene::Material& material);

// A square from (-1, -1, 0) to (1, 1, 0) that faces +Z; texture coordinate (0, 0) at its upper left
// corner.
scene::Scene square(const scene::Material& material);

// A box from (-1, -1, -1) to (1, 1, 1) with the normals of its faces: one closed mesh.
scene::Scene box(const scene::Material& material);

// Adds everything of `other`, moved by `world`.
void add(scene::Scene& scene, const scene::Scene& other, const glm::mat4& world);

// A camera at `eye` that looks at the origin with +Y up (+Z up if it looks along Y), 45 degrees
// high.
scene::Camera camera_at(const glm::vec3& eye);

scene::Material metal(float roughness, const glm::vec3& color = glm::vec3(1.0f));
scene::Material dielectric(float roughness, const glm::vec3& color = glm::vec3(0.5f));
scene::Material unlit(const glm::vec3& color);
// Clear and solid: light is bent on the way in and on the way out.
scene::Material glass(float roughness, float ior = 1.5f);

} // namespace gg::test
