#include "viewer/fields.h"
#include "viewer/panels.h"

#include <fmt/format.h>
#include <imgui.h>

namespace gg::viewer {
namespace {

void row(const char* label, const std::string& value) {
  ImGui::TableNextColumn();
  ImGui::TextUnformatted(label);
  ImGui::TableNextColumn();
  ImGui::TextUnformatted(value.c_str());
}

void draw_numbers(const image::Comparison& comparison) {
  const bool of_objects = comparison.objects.has_value();
  const image::Errors& errors = of_objects ? *comparison.objects : comparison.frame;
  if (!ImGui::BeginTable("errors", 2, ImGuiTableFlags_RowBg | ImGuiTableFlags_SizingStretchProp))
    return;
  row(of_objects ? "over the objects" : "over the picture",
      fmt::format("{} pixels", errors.pixels));
  row("relMSE", fmt::format("{:.4g}", errors.relmse));
  row("relMSE, 1 %-trimmed", fmt::format("{:.4g}", errors.relmse_trimmed));
  row("FLIP", fmt::format("{:.3f}", errors.flip));
  row("bias", fmt::format("{:+.4f}", errors.bias));
  if (errors.noise) row("relMSE from noise", fmt::format("{:.4g}", errors.noise->relmse));
  ImGui::EndTable();
}

} // namespace

void draw_truth_panel(Session& session, const std::vector<std::string>& methods) {
  ImGui::Checkbox("beside the picture (T):", &session.truth);
  const std::string truth = "the truth, path traced";
  if (ImGui::BeginCombo("second",
                        session.second.empty() ? truth.c_str() : session.second.c_str())) {
    const auto choose = [&](const std::string& method) {
      session.second = method;
      session.truth = true; // who chooses wants to see it
    };
    if (ImGui::Selectable(truth.c_str())) choose("");
    for (const std::string& method : methods)
      if (ImGui::Selectable(method.c_str())) choose(method);
    ImGui::EndCombo();
  }
  int now = static_cast<int>(session.comparing);
  const int ways =
      session.second.empty() ? IM_ARRAYSIZE(comparing_names) : 2; // errors are the truth's business
  if (now >= ways) now = 0;
  if (ImGui::Combo("shown as", &now, comparing_names, ways))
    session.comparing = static_cast<Comparing>(now);
  if (!session.truth) return;
  if (session.comparing == Comparing::wipe) slider("wipe", session.wipe, 0.0f, 1.0f, "");
  if (!session.second.empty()) {
    ImGui::Text("%s: %.1f ms a sample", session.view.method.c_str(), session.first_ms);
    ImGui::Text("%s: %.1f ms a sample", session.second.c_str(), session.second_ms);
    return;
  }
  if (!session.report) return;
  if (!session.report->failed.empty()) {
    ImGui::TextWrapped("%s", session.report->failed.c_str());
    return;
  }
  ImGui::Text("%ld sample%s per pixel, %.0f s", session.report->samples,
              session.report->samples == 1 ? "" : "s", session.report->seconds);
  if (session.report->comparison) draw_numbers(*session.report->comparison);
}

} // namespace gg::viewer
