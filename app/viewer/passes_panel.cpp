// What a sample of the picture takes, pass by pass, and what each feature in it is worth.
#include "needs/left_out.h"
#include "viewer/panels.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>

namespace gg::viewer {
namespace {

constexpr double mib = 1048576.0;

void draw_row(const std::string& label, double ms, const std::string& draws,
              const std::string& bytes) {
  ImGui::TableNextColumn();
  ImGui::TextUnformatted(label.c_str());
  ImGui::TableNextColumn();
  ImGui::Text("%.2f", ms);
  ImGui::TableNextColumn();
  ImGui::TextUnformatted(draws.c_str());
  ImGui::TableNextColumn();
  ImGui::TextUnformatted(bytes.c_str());
}

void draw_passes(const Session& session) {
  if (!ImGui::BeginTable("passes", 4, ImGuiTableFlags_RowBg | ImGuiTableFlags_SizingStretchProp))
    return;
  for (const char* title : {"pass", "ms", "draws", "MiB"})
    ImGui::TableSetupColumn(title);
  ImGui::TableHeadersRow();
  double total = 0.0;
  for (const Session::PassRow& pass : session.passes) {
    const auto ms = session.pass_ms.find(pass.label);
    const double taken = ms == session.pass_ms.end() ? 0.0 : ms->second;
    total += taken;
    draw_row(pass.passes > 1 ? fmt::format("{} x {}", pass.label, pass.passes) : pass.label, taken,
             pass.draws ? std::to_string(pass.draws) : "",
             fmt::format("{:.1f}", static_cast<double>(pass.bytes) / mib));
  }
  draw_row("all", total, "", "");
  ImGui::EndTable();
}

// Those in use, which can be left out where the name before a colon says so, and those that are left out.
void draw_features(Session& session) {
  std::set<std::string>& without = session.view.without;
  const auto& names = needs::names_to_leave_out();
  for (const needs::FeatureUse& feature : session.features) {
    const std::string name = feature.name.substr(0, feature.name.find(':'));
    const std::string text =
        fmt::format("{}: {} draw{}", feature.name, feature.draws, feature.draws == 1 ? "" : "s");
    bool on = true;
    if (std::ranges::find(names, name) == names.end()) {
      ImGui::TextUnformatted(text.c_str());
    } else if (ImGui::Checkbox(text.c_str(), &on)) {
      without.insert(name);
      session.requests.quality = true;
    }
  }
  for (const std::string& name : std::set(without)) {
    bool on = false;
    if (!ImGui::Checkbox((name + ": left out").c_str(), &on)) continue;
    without.erase(name);
    session.requests.quality = true;
  }
}

} // namespace

void draw_passes_panel(Session& session) {
  draw_passes(session);
  draw_features(session);
  ImGui::Text("%.1f MiB on the device", static_cast<double>(session.device_bytes) / mib);
}

} // namespace gg::viewer
