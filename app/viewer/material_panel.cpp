// Everything that --material can say, as controls.
#include "scene/presets.h"
#include "viewer/fields.h"
#include "viewer/panels.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

namespace gg::viewer {
namespace {

// Keys of --material that it refuses for metals.
constexpr std::array<std::string_view, 7> not_of_metals = {
    "color",      "ior",       "thickness", "attenuation_distance", "attenuation_color",
    "back_alpha", "dispersion"};
constexpr ImGuiSliderFlags from_small = ImGuiSliderFlags_Logarithmic;

class Controls {
public:
  Controls(Session& session, const std::vector<scene::Index>& chosen)
      : session_(session), chosen_(chosen),
        shown_(session.scene->materials[static_cast<std::size_t>(chosen.front())]) {}

  void preset() {
    std::string current = edit().preset.empty() ? "as in the file" : edit().preset;
    if (!ImGui::BeginCombo("preset", current.c_str())) return;
    if (ImGui::Selectable("as in the file", edit().preset.empty())) each([](Edit& e) { e = {}; });
    for (const scene::Preset& preset : scene::presets())
      if (preset.kind != scene::PresetKind::finish) {
        const std::string name(preset.name);
        if (ImGui::Selectable(name.c_str(), name == current))
          each([&](Edit& e) { e = {.preset = name, .settings = {}}; });
      }
    ImGui::EndCombo();
  }

  void finish() {
    const std::string* current = edit().find("finish");
    if (!ImGui::BeginCombo("finish", current ? current->c_str() : "")) return;
    for (const scene::Preset& preset : scene::presets())
      if (preset.kind == scene::PresetKind::finish) {
        const std::string name(preset.name);
        if (ImGui::Selectable(name.c_str(), current && name == *current))
          each([&](Edit& e) {
            e.erase("alpha"), e.erase("roughness");
            e.set("finish", name);
          });
      }
    ImGui::EndCombo();
  }

  void width() {
    const float alpha = microfacet_alpha(shown_);
    if (float a = alpha; slider("alpha", a, 0.0f, 1.0f, "%.4f", from_small)) set_width("alpha", a);
    if (float r = std::sqrt(alpha); slider("roughness", r, 0.0f, 1.0f, "%.3f"))
      set_width("roughness", r);
    finish();
    if (!lets_light_in()) return;
    float back = shown_.back_alpha.value_or(alpha);
    if (slider("back alpha", back, 0.0f, 1.0f, "%.4f", from_small))
      set("back_alpha", fmt::format("{}", back));
  }

  void distribution() {
    constexpr const char* names[] = {"ggx", "beckmann", "phong"};
    int now = static_cast<int>(shown_.distribution);
    if (ImGui::Combo("distribution", &now, names, 3)) set("distribution", names[now]);
  }

  void colour() { color("colour", "color", shown_.base_color); }

  void glass() {
    number("IOR", "ior", shown_.ior, 0.25f, 4.0f, "%.3f");
    number("dispersion", "dispersion", shown_.dispersion, 0.0f, 2.0f, "%.3f");
    if (!lets_light_in()) return;
    float thickness = shown_.thickness;
    if (ImGui::DragFloat("thickness", &thickness,
                         0.01f * std::max(session_.scene->bounds.radius(), 1e-6f), 0.0f, 1e6f,
                         "%.4g")
        && std::isfinite(thickness))
      set("thickness", fmt::format("{}", std::max(thickness, 0.0f)));
    color("absorption", "attenuation_color", glm::vec4(shown_.attenuation_color, 1.0f));
    // A point is as large as a micrometre.
    const float radius = std::max(session_.scene->bounds.radius(), 1e-6f);
    float distance =
        std::isfinite(shown_.attenuation_distance) ? shown_.attenuation_distance : 100.0f * radius;
    if (slider("at distance", distance, 1e-3f * radius, 100.0f * radius, "%.4g m", from_small))
      set("attenuation_distance", fmt::format("{}", distance));
  }

  // Over all of these but unlit surfaces.
  void layers() {
    number("clearcoat", "clearcoat", shown_.clearcoat, 0.0f, 1.0f, "%.3f");
    if (shown_.clearcoat > 0.0f)
      number("coat roughness", "clearcoat_roughness", shown_.clearcoat_roughness, 0.0f, 1.0f,
             "%.3f");
    number("thin film", "iridescence", shown_.iridescence, 0.0f, 1.0f, "%.3f");
    if (shown_.iridescence > 0.0f) {
      number("film IOR", "iridescence_ior", shown_.iridescence_ior, 1.0f, 4.0f, "%.3f");
      number("film thickness", "iridescence_thickness", shown_.iridescence_thickness.y, 0.0f,
             2000.0f, "%.0f nm");
    }
    number("brushing", "anisotropy", shown_.anisotropy_strength, 0.0f, 1.0f, "%.3f");
    if (shown_.anisotropy_strength > 0.0f)
      number("brushed along", "anisotropy_rotation", glm::degrees(shown_.anisotropy_rotation),
             -180.0f, 180.0f, "%.0f deg");
  }

  bool is_metal() const { return shown_.conductor.has_value(); }
  void reset() {
    if (ImGui::Button("Reset to file")) each([](Edit& e) { e = {}; });
  }

private:
  const Edit& edit() {
    static const Edit none;
    const auto i = static_cast<std::size_t>(chosen_.front());
    return i < session_.view.edits.size() ? session_.view.edits[i] : none;
  }
  bool lets_light_in() const { return shown_.transmission > 0.0f && !shown_.conductor; }

  template <class Change>
  void each(Change change) {
    for (const scene::Index i : chosen_)
      change(edit_of(session_.view, i));
    session_.requests.materials = true;
  }
  // Of metals among all, what does not apply to them is left out.
  void set(const char* key, const std::string& value) {
    for (const scene::Index i : chosen_) {
      const bool metal =
          session_.scene->materials[static_cast<std::size_t>(i)].conductor.has_value();
      if (!metal || std::ranges::find(not_of_metals, std::string_view(key)) == not_of_metals.end())
        edit_of(session_.view, i).set(key, value);
    }
    session_.requests.materials = true;
  }
  void set_width(const char* key, float value) {
    each([](Edit& e) { e.erase("alpha"), e.erase("roughness"), e.erase("finish"); });
    set(key, fmt::format("{}", value));
  }
  void number(const char* label, const char* key, float value, float least, float most,
              const char* format) {
    if (slider(label, value, least, most, format)) set(key, fmt::format("{}", value));
  }
  void color(const char* label, const char* key, const glm::vec4& linear) {
    float rgb[3] = {linear.x, linear.y, linear.z};
    if (colour_field(label, rgb, 1.0f)) set(key, fmt::format("{}/{}/{}", rgb[0], rgb[1], rgb[2]));
  }

  Session& session_;
  const std::vector<scene::Index>& chosen_;
  const scene::Material& shown_;
};

std::string title(const Session& session, const std::vector<scene::Index>& chosen) {
  if (session.edit_all) return fmt::format("all {} materials", chosen.size());
  const scene::Material& material =
      session.scene->materials[static_cast<std::size_t>(chosen.front())];
  const std::string& object =
      session.scene->instances[static_cast<std::size_t>(session.picked->instance)].name;
  return fmt::format("{}{}{}", object, object.empty() ? "" : ": ",
                     material.name.empty() ? fmt::format("material #{}", chosen.front())
                                           : material.name);
}

} // namespace

void draw_material_panel(Session& session) {
  ImGui::Checkbox("all objects", &session.edit_all);
  const std::vector<scene::Index> chosen = chosen_materials(session);
  if (chosen.empty()) {
    ImGui::TextDisabled("Click an object to change its material.");
    return;
  }
  ImGui::TextWrapped("%s", title(session, chosen).c_str());
  Controls controls(session, chosen);
  controls.preset();
  controls.width();
  controls.distribution();
  if (!controls.is_metal()) {
    controls.colour();
    controls.glass();
  }
  controls.layers();
  controls.reset();
  ImGui::SameLine();
  if (ImGui::Button("Undo")) session.requests.undo = true;
  ImGui::SameLine();
  if (ImGui::Button("Redo")) session.requests.redo = true;
}

} // namespace gg::viewer
