// Housekeeping on a finished Scene.
#pragma once

#include "scene/scene.h"

namespace gg::scene {

// Drops the streams and index lists that no primitive names (what was read only to be transformed),
// and renumbers the rest.
void compact(Scene& scene);

// The box around everything that is drawn, in the world. Tight: of the vertices, not of their boxes,
// unless there are so many turned instances that looking at each vertex would take long.
Bounds world_bounds(const Scene& scene);

// Where scenes end: squares of distances must stay floats, with room for a camera further off.
inline constexpr float largest_radius = 1e17f;

} // namespace gg::scene
