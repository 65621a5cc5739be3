// What lights the scene, and what is seen behind it.
#include "environment/map.h"
#include "viewer/fields.h"
#include "viewer/panels.h"

#include <fmt/format.h>
#include <imgui.h>

#include <filesystem>
#include <sstream>

namespace gg::viewer {
namespace {

namespace fs = std::filesystem;

// What the view's map is called; of a file, its name without folder and extension.
std::string name_of(const View& view) {
  if (view.env.empty()) return "royal_esplanade";
  if (!environment::is_map_file(view.env)) return view.env; // a name, `none` or a colour
  return fs::path(view.env).stem().string();
}

void draw_thumbnails(Session& session, float scale) {
  const std::string now = name_of(session.view);
  const ImVec2 size(thumbnail_width * scale, thumbnail_height * scale);
  const ImVec4 shown = ImGui::GetStyleColorVec4(ImGuiCol_CheckMark);
  for (std::size_t i = 0; i < session.environments.size(); ++i) {
    const Thumbnail& one = session.environments[i];
    const std::string name = fs::path(one.path).stem().string();
    const auto& [left, top, right, bottom] = one.place;
    ImGui::PushID(static_cast<int>(i));
    const bool chosen = name.starts_with(now);
    ImGui::PushStyleColor(ImGuiCol_Button, chosen ? shown : ImVec4(0.0f, 0.0f, 0.0f, 0.0f));
    if (ImGui::ImageButton(ImGui::GetIO().Fonts->TexID, size, {left, top}, {right, bottom}, 2))
      session.requests.open = one.path;
    ImGui::PopStyleColor();
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", name.c_str());
    ImGui::PopID();
    if (i + 1 < session.environments.size()) ImGui::SameLine(0.0f, 2.0f * scale);
  }
}

bool draw_background(View& view) {
  const bool plain = view.background != "sharp" && view.background != "blurred";
  bool changed = false;
  if (ImGui::BeginCombo("background", plain ? "plain" : view.background.c_str())) {
    for (const char* kind : {"sharp", "blurred", "plain"})
      if (ImGui::Selectable(kind)) {
        view.background = std::string(kind) == "plain" ? "0.2,0.2,0.2" : kind;
        changed = true;
      }
    ImGui::EndCombo();
  }
  if (!plain) return changed;
  float rgb[3] = {};
  char comma = 0;
  std::istringstream(view.background) >> rgb[0] >> comma >> rgb[1] >> comma >> rgb[2];
  constexpr float brightest = 65504.0f; // of a float of 16 bits
  if (colour_field("colour behind", rgb, brightest)) {
    view.background = fmt::format("{},{},{}", rgb[0], rgb[1], rgb[2]);
    changed = true;
  }
  return changed;
}

} // namespace

void draw_environment_panel(Session& session, float scale) {
  View& view = session.view;
  ImGui::TextUnformatted(name_of(view).c_str());
  draw_thumbnails(session, scale);
  bool changed = slider("rotation", view.env_rotation, -180.0f, 180.0f, "%.1f deg");
  changed |=
      slider("intensity", view.env_intensity, 0.0f, 8.0f, "%.3f", ImGuiSliderFlags_Logarithmic);
  if (session.map) changed |= draw_background(view);
  session.requests.light |= changed;
}

} // namespace gg::viewer
