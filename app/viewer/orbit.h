// Moving a camera about what it looks at. Pure: no window, no device.
#pragma once

#include "scene/scene.h"
#include "viewer/view.h"

#include <glm/glm.hpp>

namespace gg::viewer {

// The place of a file's camera; its target is where its line of sight passes closest to the middle of the bounds, in front of it.
Place place_of(const scene::Camera& camera, const scene::Bounds& bounds);

// Turns about the target: `yaw` about `up`, then `pitch`, radians; never over the poles (Blender's and model-viewer's turntable).
void orbit(Place& place, float yaw, float pitch);
// Moves eye and target in the picture's plane, so that what is at the target follows the mouse: x right, y down, in heights of the
// picture.
void pan(Place& place, const glm::vec2& heights);
// Makes the distance `factor` times as long, with what is under the cursor staying there. `cursor` in heights of the picture from
// its middle, x right, y down. The distance keeps to 1e-4 .. 1e4 of `radius`.
void dolly(Place& place, float factor, const glm::vec2& cursor, float radius);
// The whole of the bounds in the picture, seen from the same side.
void frame(Place& place, const scene::Bounds& bounds, float aspect);
// Orthographic or perspective, with what is at the target as large as before.
void set_orthographic(Place& place, bool on);
// From +Z (front), +X (right), +Y (top), or their opposites.
enum class Side { front, back, right, left, top, bottom };
void look_from(Place& place, Side side);

} // namespace gg::viewer
