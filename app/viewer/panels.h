// The panels beside the picture, in Dear ImGui.
#pragma once

#include "viewer/session.h"
#include "viewer/thumbnails.h"

#include <string>
#include <vector>

namespace gg::viewer {

// Fonts, colours and thumbnails, once, before the first frame; `scale` as Window::scale().
std::vector<Thumbnail> set_up_panels(float scale, Thumbnails& thumbnails);
// The width of the panels, in Dear ImGui's coordinates; 0 if they are hidden.
float panel_width(const Session& session, float scale);

// All of them; `methods` as --method takes them.
void draw_panels(Session& session, const std::vector<std::string>& methods, float scale);

void draw_material_panel(Session& session);
void draw_truth_panel(Session& session, const std::vector<std::string>& methods);
void draw_environment_panel(Session& session, float scale);
void draw_passes_panel(Session& session);
void draw_inspector(const Session& session, float scale);

} // namespace gg::viewer
