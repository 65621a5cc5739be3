#include "viewer/panels.h"

#include "core/files.h"
#include "viewer/fields.h"
#include "viewer/input.h"

#include <fmt/format.h>
#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace gg::viewer {
namespace {

namespace fs = std::filesystem;

constexpr float width_of_panels = 340.0f;

// For a field with a button of these words to its right; the panel's scale is in the letters.
void leave_room_for(const char* button) {
  const ImGuiStyle& style = ImGui::GetStyle();
  ImGui::SetNextItemWidth(
      -(ImGui::CalcTextSize(button).x + 2.0f * style.FramePadding.x + style.ItemSpacing.x));
}

void draw_scene_panel(Session& session) {
  static std::string path;
  leave_room_for("Open");
  bool entered =
      ImGui::InputTextWithHint("##path", ".gltf, .glb, .hdr or .exr: type, or drop it here", &path,
                               ImGuiInputTextFlags_EnterReturnsTrue);
  entered |= session.entered && ImGui::IsItemActive();
  ImGui::SameLine();
  if ((ImGui::Button("Open") || entered) && !path.empty()) session.requests.open = path;
  if (!session.recent.empty() && ImGui::BeginCombo("##recent", "recent files")) {
    for (const std::string& recent : session.recent)
      if (ImGui::Selectable(recent.c_str())) session.requests.open = recent;
    ImGui::EndCombo();
  }
  if (!session.scene) return;
  const std::size_t objects = session.scene->instances.size();
  ImGui::TextWrapped("%s: %zu object%s, %zu triangles",
                     fs::path(session.view.scene).filename().c_str(), objects,
                     objects == 1 ? "" : "s", session.scene->triangle_count());
}

void draw_camera_panel(Session& session) {
  const auto& cameras = session.scene->cameras;
  const std::string now = session.view.place             ? "moved"
                          : !session.view.camera.empty() ? session.view.camera
                          : cameras.empty()              ? "all of the scene"
                                                         : "the file's first";
  if (ImGui::BeginCombo("camera", now.c_str())) {
    const auto choose = [&](const std::string& camera) {
      session.view.camera = camera;
      session.view.place.reset();
      session.requests.camera = true;
    };
    if (ImGui::Selectable(cameras.empty() ? "all of the scene" : "the file's first")) choose("");
    for (std::size_t i = 0; i < cameras.size(); ++i)
      if (ImGui::Selectable(fmt::format("{} {}", i, cameras[i].name).c_str()))
        choose(std::to_string(i));
    ImGui::EndCombo();
  }
  float fovy = session.view.place ? session.view.place->fovy : glm::degrees(session.camera.fovy);
  if (!session.camera.orthographic && slider("field of view", fovy, 5.0f, 120.0f, "%.1f deg")) {
    if (!session.view.place) session.view.place = place_of(session.camera, session.scene->bounds);
    session.view.place->fovy = fovy;
    session.requests.camera = true;
  }
  bool flat = session.camera.orthographic;
  if (ImGui::Checkbox("orthographic (5)", &flat)) {
    if (!session.view.place) session.view.place = place_of(session.camera, session.scene->bounds);
    set_orthographic(*session.view.place, flat);
    session.requests.camera = true;
  }
  if (ImGui::Button("Frame all")) session.requests.frame_all = true;
  ImGui::SameLine();
  if (ImGui::Button("Frame picked") && session.picked) session.requests.frame_picked = true;
  ImGui::SameLine();
  ImGui::Checkbox("turntable", &session.turntable);
}

void draw_animation_panel(Session& session) {
  View& view = session.view;
  const auto& names = session.scene->animations;
  const auto& posed = session.scene->posed;
  if (ImGui::BeginCombo("animation", posed ? posed->animation.c_str() : "as the nodes stand")) {
    for (std::size_t i = 0; i < names.size(); ++i)
      if (ImGui::Selectable(fmt::format("{}##{}", names[i], i).c_str())) {
        view.animation = std::to_string(i);
        view.time = 0.0f;
        session.requests.pose = true;
      }
    ImGui::EndCombo();
  }
  if (ImGui::Button(session.playing ? "Pause (P)" : "Play (P)")) session.playing = !session.playing;
  ImGui::SameLine();
  float time = view.time.value_or(0.0f);
  ImGui::SetNextItemWidth(-1.0f);
  if (slider("##time", time, 0.0f, posed ? std::max(posed->end, 1e-3f) : 1.0f, "%.3f s")) {
    view.time = time;
    session.playing = false;
    session.requests.pose = true;
  }
}

void draw_quality_panel(Session& session, const std::vector<std::string>& methods) {
  View& view = session.view;
  bool changed = false;
  if (ImGui::BeginCombo("method", view.method.c_str())) {
    for (const std::string& method : methods)
      if (ImGui::Selectable(method.c_str(), method == view.method)) {
        view.method = method;
        changed = true;
      }
    ImGui::EndCombo();
  }
  changed |= ImGui::SliderInt("samples", &view.samples, 1, 64, "%d", ImGuiSliderFlags_AlwaysClamp);
  bool correlated = view.smith == "correlated";
  if (ImGui::Checkbox("correlated Smith", &correlated)) {
    view.smith = correlated ? "correlated" : "separable";
    changed = true;
  }
  changed |= ImGui::Checkbox("multiple scattering", &view.multiscatter);
  session.requests.quality |= changed;
  slider("exposure", view.exposure, -8.0f, 8.0f, "%+.2f EV");
  constexpr const char* curves[] = {"none", "neutral", "aces", "agx"};
  if (ImGui::BeginCombo("tone curve", view.tonemap.c_str())) {
    for (const char* curve : curves)
      if (ImGui::Selectable(curve)) view.tonemap = curve;
    ImGui::EndCombo();
  }
  auto rate = static_cast<float>(session.frames_per_second);
  if (slider("in motion", rate, 5.0f, 120.0f, "%.0f frames/s")) session.frames_per_second = rate;
  ImGui::Checkbox("standard in motion where others are slow", &session.standard_in_motion);
}

void draw_save_panel(Session& session) {
  ImGui::TextUnformatted("Copy this view as a command line:");
  for (const char* command : {"capture", "truth", "report"}) {
    if (ImGui::Button(command)) session.requests.copy = command;
    ImGui::SameLine();
  }
  ImGui::NewLine();
  static std::string picture = "groundglass.png", copy = "edited.glb";
  leave_room_for("Save picture");
  ImGui::InputText("##picture", &picture);
  ImGui::SameLine();
  if (ImGui::Button("Save picture")) session.requests.save_picture = picture;
  leave_room_for("Save picture"); // as wide as the field above
  ImGui::InputText("##copy", &copy);
  ImGui::SameLine();
  if (ImGui::Button("Save glTF")) session.requests.save_materials = copy;
}

void draw_debug_panel(Session& session) {
  int kind = static_cast<int>(session.debug);
  if (ImGui::Combo("shows", &kind, debug_names, IM_ARRAYSIZE(debug_names)))
    session.debug = static_cast<DebugKind>(kind);
  if (session.debug == DebugKind::depth || session.debug == DebugKind::path_length)
    ImGui::Text("black 0, yellow %.4g m", session.debug_greatest);
  if (session.debug == DebugKind::interior_layers)
    ImGui::Text("black 0, yellow %.0f", session.debug_greatest);
  if (session.debug == DebugKind::sigma_in_pixels)
    ImGui::Text("black 0, yellow %.3g pixels", session.debug_greatest);
  if (session.debug == DebugKind::screen_share)
    ImGui::TextUnformatted("blue the environment, orange the screen");
  if (session.debug == DebugKind::samples)
    ImGui::Text("black 0, yellow %.0f lookups of a pixel", session.debug_greatest);
}

std::string truth_words(const TruthRun::Report* report) {
  if (!report) return "truth: starts when nothing moves";
  std::string words =
      fmt::format("truth: {} sample{} per pixel", report->samples, report->samples == 1 ? "" : "s");
  // One sample does not say how far others would be from it.
  if (report->samples > 1) words += fmt::format(", error {:.1f} %", 100.0 * report->error);
  return words;
}

std::string status_words(const Session& session) {
  std::string line;
  if (!session.loading.empty())
    line = session.loading;
  else if (!session.scene)
    line = "drop a .gltf or .glb here";
  else if (session.moving)
    line =
        fmt::format("{:.0f} ms at {:.0f} % of the width{}", session.frame_ms, 100.0 * session.scale,
                    session.moving_method == session.view.method
                        ? ""
                        : ", by " + session.moving_method + " meanwhile");
  else if (session.compiled < 1.0)
    line = fmt::format("compiling shaders: {:.0f} %", 100.0 * session.compiled);
  else if (session.drawn == 0)
    line = "drawing the first sample";
  else
    line = fmt::format("{} of {} samples", session.drawn, session.view.samples);
  if (session.truth && session.second.empty()) line += "   " + truth_words(session.report.get());
  if (!session.said.empty()) line += "   " + session.said;
  return line;
}

void draw_status(const Session& session, float scale) {
  const ImGuiIO& io = ImGui::GetIO();
  const std::string line = status_words(session);
  // Dear ImGui's own fitting is a frame late, and that frame may be the last for a while.
  const ImVec2 text = ImGui::CalcTextSize(line.c_str()), padding = ImGui::GetStyle().WindowPadding;
  ImGui::SetNextWindowSize({text.x + 2.0f * padding.x, text.y + 2.0f * padding.y});
  ImGui::SetNextWindowPos({8.0f * scale, io.DisplaySize.y - 8.0f * scale}, ImGuiCond_Always,
                          {0.0f, 1.0f});
  ImGui::SetNextWindowBgAlpha(0.55f);
  constexpr ImGuiWindowFlags flags = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoInputs
                                     | ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoNav;
  ImGui::Begin("status", nullptr, flags);
  ImGui::TextUnformatted(line.c_str());
  ImGui::End();
}

void draw_message(Session& session, float scale) {
  if (session.message.empty()) return;
  const ImGuiIO& io = ImGui::GetIO();
  const float right = io.DisplaySize.x - panel_width(session, scale);
  ImGui::SetNextWindowPos({0.5f * right, 16.0f * scale}, ImGuiCond_Always, {0.5f, 0.0f});
  ImGui::SetNextWindowSize({std::min(640.0f * scale, 0.9f * right), 0.0f});
  ImGui::Begin("message", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_AlwaysAutoResize);
  ImGui::TextWrapped("%s", session.message.c_str());
  if (ImGui::Button("Close")) session.message.clear();
  ImGui::End();
}

void draw_shader_message(const Session& session, float scale) {
  if (session.shader_message.empty()) return;
  const ImGuiIO& io = ImGui::GetIO();
  const float right = io.DisplaySize.x - panel_width(session, scale);
  ImGui::SetNextWindowPos({0.5f * right, 0.5f * io.DisplaySize.y}, ImGuiCond_Always, {0.5f, 0.5f});
  ImGui::SetNextWindowSize({0.9f * right, 0.0f});
  ImGui::Begin("shaders", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_AlwaysAutoResize
                   | ImGuiWindowFlags_NoInputs);
  ImGui::TextUnformatted("A shader does not compile; the picture is still of the one before:");
  ImGui::TextWrapped("%s", session.shader_message.c_str());
  ImGui::End();
}

} // namespace

std::vector<Thumbnail> set_up_panels(float scale, Thumbnails& thumbnails) {
  ImGuiIO& io = ImGui::GetIO();
  io.ConfigInputTextCursorBlink = false; // an idle window draws nothing
  io.ConfigWindowsMoveFromTitleBarOnly = true;
  ImGui::StyleColorsDark();
  ImGuiStyle& style = ImGui::GetStyle();
  style.WindowRounding = style.FrameRounding = style.GrabRounding = 3.0f;
  style.ScaleAllSizes(scale);
  // Debian's fonts-dejavu-core; without it, Dear ImGui's own letters.
  const fs::path font = "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf";
  std::error_code none;
  if (fs::exists(font, none)) io.Fonts->AddFontFromFileTTF(font.c_str(), std::round(14.0f * scale));
  return thumbnails.in_atlas(scale);
}

float panel_width(const Session& session, float scale) {
  return session.panel ? std::round(width_of_panels * scale) : 0.0f;
}

void draw_panels(Session& session, const std::vector<std::string>& methods, float scale) {
  draw_status(session, scale);
  draw_message(session, scale);
  draw_shader_message(session, scale);
  draw_inspector(session, scale);
  if (!session.panel) return;
  const ImGuiIO& io = ImGui::GetIO();
  const float width = panel_width(session, scale);
  ImGui::SetNextWindowPos({io.DisplaySize.x - width, 0.0f});
  ImGui::SetNextWindowSize({width, io.DisplaySize.y});
  ImGui::Begin("Groundglass", nullptr,
               ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove
                   | ImGuiWindowFlags_NoCollapse);
  ImGui::PushItemWidth(0.58f * width);
  constexpr ImGuiTreeNodeFlags open = ImGuiTreeNodeFlags_DefaultOpen;
  if (ImGui::CollapsingHeader("Scene", open)) draw_scene_panel(session);
  if (session.scene) {
    if (ImGui::CollapsingHeader("Material", open)) draw_material_panel(session);
    if (ImGui::CollapsingHeader("Environment", open)) draw_environment_panel(session, scale);
    if (ImGui::CollapsingHeader("Compare", open)) draw_truth_panel(session, methods);
    if (ImGui::CollapsingHeader("Camera")) draw_camera_panel(session);
    if (!session.scene->animations.empty() && ImGui::CollapsingHeader("Animation", open))
      draw_animation_panel(session);
    if (ImGui::CollapsingHeader("Picture")) draw_quality_panel(session, methods);
    if (ImGui::CollapsingHeader("Copy and save")) draw_save_panel(session);
    draw_debug_panel(session);
    ImGui::Checkbox("inspect lobes under the cursor (I)", &session.inspector);
    session.pass_table = ImGui::CollapsingHeader("Passes");
    if (session.pass_table) draw_passes_panel(session);
  }
  if (ImGui::CollapsingHeader("Keys")) ImGui::TextUnformatted(help());
  ImGui::PopItemWidth();
  ImGui::End();
}

} // namespace gg::viewer
