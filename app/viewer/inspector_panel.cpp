// The lobe inspector: what is under the cursor, in numbers and as a polar plot.
#include "viewer/inspector.h"
#include "viewer/panels.h"

#include <fmt/format.h>
#include <glm/trigonometric.hpp>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gg::viewer {
namespace {

constexpr ImU32 grid = IM_COL32(120, 120, 125, 120), text = IM_COL32(220, 220, 220, 255),
                reflected = IM_COL32(255, 170, 60, 255), passes = IM_COL32(90, 180, 235, 255),
                fit = IM_COL32(255, 255, 255, 230);

// A half of the plot: above the surface, or below.
struct Half {
  ImVec2 centre;
  float radius;
  float up; // 1 above
  ImVec2 at(double angle, double r) const {
    return {centre.x + radius * static_cast<float>(r * std::sin(angle)),
            centre.y - up * radius * static_cast<float>(r * std::cos(angle))};
  }
};

void draw_lobe(ImDrawList& list, const Half& half, const InspectedLobe& lobe, ImU32 colour) {
  double largest = 0.0;
  for (const LobeValue& value : lobe.exact)
    largest = std::max({largest, value.value, lobe.fit_at(value.angle)});
  if (!(largest > 0.0)) return;
  std::vector<ImVec2> exact, fitted;
  for (const LobeValue& value : lobe.exact) {
    exact.push_back(half.at(value.angle, value.value / largest));
    fitted.push_back(half.at(value.angle, lobe.fit_at(value.angle) / largest));
  }
  list.AddPolyline(exact.data(), static_cast<int>(exact.size()), colour, ImDrawFlags_None, 2.0f);
  list.AddPolyline(fitted.data(), static_cast<int>(fitted.size()), fit, ImDrawFlags_None, 1.0f);
  for (const FittedLobe& one : lobe.fitted)
    list.AddLine(half.centre, half.at(one.angle, 1.0), (colour & 0x00ffffffu) | 0x90000000u, 1.0f);
}

void draw_plot(const Inspection& found, float scale) {
  const float radius = 100.0f * scale, margin = 8.0f * scale;
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const bool both = !found.passes.exact.empty();
  const ImVec2 centre(corner.x + radius + margin, corner.y + radius + margin);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  for (const float up : {1.0f, -1.0f}) {
    if (up < 0.0f && !both) continue;
    const Half half{centre, radius, up};
    for (const double r : {0.5, 1.0}) {
      std::vector<ImVec2> arc;
      for (int step = -90; step <= 90; step += 5)
        arc.push_back(half.at(glm::radians(static_cast<double>(step)), r));
      list.AddPolyline(arc.data(), static_cast<int>(arc.size()), grid, ImDrawFlags_None, 1.0f);
    }
    for (int step = -60; step <= 60; step += 30)
      list.AddLine(centre, half.at(glm::radians(static_cast<double>(step)), 1.0), grid);
    draw_lobe(list, half, up > 0.0f ? found.reflected : found.passes,
              up > 0.0f ? reflected : passes);
  }
  list.AddLine({centre.x - radius, centre.y}, {centre.x + radius, centre.y}, text, 1.0f);
  const Half above{centre, radius, 1.0f};
  list.AddLine(above.at(-found.incidence, 1.0), centre, text, 2.0f); // from the viewer
  ImGui::Dummy({2.0f * (radius + margin), (both ? 2.0f : 1.0f) * radius + 2.0f * margin});
}

void draw_lobes(const char* what, const InspectedLobe& lobe, ImU32 colour) {
  ImGui::TextColored(ImGui::ColorConvertU32ToFloat4(colour), "%s: %.4f of the light", what,
                     lobe.energy);
  for (const FittedLobe& one : lobe.fitted)
    ImGui::Text("  %5.1f deg   sigma %.2f deg   weight %.2f", glm::degrees(one.angle),
                glm::degrees(one.sigma), one.weight);
}

std::string name_of(const scene::Scene& scene, scene::Index instance) {
  const std::string& name = scene.instances[static_cast<std::size_t>(instance)].name;
  return name.empty() ? fmt::format("object #{}", instance) : name;
}

} // namespace

void draw_inspector(const Session& session, float scale) {
  if (!session.inspected) return;
  const Inspection& found = *session.inspected;
  const scene::Scene& scene = *session.scene;
  ImGui::SetNextWindowPos({8.0f * scale, 8.0f * scale});
  ImGui::Begin("inspector", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_AlwaysAutoResize
                   | ImGuiWindowFlags_NoInputs | ImGuiWindowFlags_NoFocusOnAppearing);
  const scene::Material& material = scene.materials[static_cast<std::size_t>(found.material)];
  ImGui::Text("%s: %s", name_of(scene, found.instance).c_str(), material.name.c_str());
  if (found.unlit) {
    ImGui::TextUnformatted("unlit: shows its colour and nothing else");
    ImGui::End();
    return;
  }
  ImGui::Text("alpha %.4f   at %.1f deg", found.alpha, glm::degrees(found.incidence));
  ImGui::Text("F %.4f   1 - F %.4f", found.fresnel, 1.0 - found.fresnel);
  if (found.coat > 0.0)
    ImGui::Text("under a coat of %.2f, alpha %.3f: not in the plot", found.coat, found.coat_alpha);
  if (found.film) ImGui::TextUnformatted("under a thin film: not in the plot");
  if (found.brushed) ImGui::TextUnformatted("brushed: plotted with its mean width");
  if (found.mixed) ImGui::TextUnformatted("part metal: plotted as what it is most");
  draw_plot(found, scale);
  ImGui::TextUnformatted("coloured: exact f |cos|   white: its Gaussians");
  draw_lobes("reflected", found.reflected, reflected);
  if (!found.passes.exact.empty()) draw_lobes("passes", found.passes, passes);
  if (const auto& exit = found.leaves) {
    if (exit->length > 0.0) ImGui::Text("inside: %.4g m", exit->length);
    if (exit->reflected)
      ImGui::TextUnformatted("internally reflected at the exit");
    else
      ImGui::Text("leaves at %.4g, %.4g, %.4g", static_cast<double>(exit->position.x),
                  static_cast<double>(exit->position.y), static_cast<double>(exit->position.z));
    if (!exit->reflected && exit->meets == scene::none)
      ImGui::TextUnformatted("meets the environment");
    else if (!exit->reflected)
      ImGui::Text("meets %s, %.4g m behind", name_of(scene, exit->meets).c_str(), exit->distance);
  }
  ImGui::End();
}

} // namespace gg::viewer
