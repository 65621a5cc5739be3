// What the mouse and the keyboard do to a session, by the conventions of Blender and model-viewer.
#pragma once

#include "gpu/window.h"
#include "viewer/session.h"

namespace gg::viewer {

// Where the picture is, in Dear ImGui's coordinates; it begins at (0, 0).
struct Area {
  float width = 1.0f, height = 1.0f;
};

// After the panels have been built, which come first: keys that were pressed, movements with a button held, and of ImGui::GetIO()
// the wheel. `seconds` since the last call, for the turntable.
void take_input(Session& session, const Area& area, const std::vector<gpu::KeyPress>& keys,
                const std::vector<gpu::Drag>& drags, double seconds);

// What the keys are, for the panel.
const char* help();

} // namespace gg::viewer
