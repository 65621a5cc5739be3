// Where to look from.
#pragma once

#include "scene/scene.h"

#include <string>

namespace gg::scene {

// Looks at the whole scene from +Z (a flat scene from its broad side: from +Y where it lies, from +X where it stands along
// Z): the centre of the bounds in the middle, fovy 45° (vertical),
// everything inside a picture of the given aspect (width / height) with a small margin. An empty
// scene is looked at as if it were a unit sphere.
Camera default_camera(const Scene& scene, float aspect);

// A camera at `eye` that looks at `target`; fovy in radians; near and far from the bounds. Throws
// Error(usage) if eye and target coincide, `up` is along the line of sight, or fovy is not in
// (0, pi).
Camera look_at(const Scene& scene, const glm::vec3& eye, const glm::vec3& target,
               const glm::vec3& up, float fovy);

// The camera of that name, or with that number (from 0, in the order of the file's nodes). Throws
// Error(usage) that lists the cameras there are, and what usable_camera throws.
const Camera& find_camera(const Scene& scene, const std::string& name_or_index);

// The camera itself. Throws Error(input) with what is wrong with it in the file.
const Camera& usable_camera(const Camera& camera);

// Sets near and far to enclose the bounds as seen from where the camera stands, with some room for
// what touches them. Near is a 1000th of the scene's radius or more where nothing is nearer; else as little as
// shows what is nearest, down to a millionth of the radius.
void fit_depth(Camera& camera, const Scene& scene);

} // namespace gg::scene
