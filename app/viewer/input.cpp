#include "viewer/input.h"

#include <imgui.h>

#include <cmath>

namespace gg::viewer {
namespace {

constexpr float turn_per_height =
    3.14159265f; // dragging across the picture's height turns by half a circle
constexpr float key_step = 0.0872664626f; // of an arrow key: 5 degrees
constexpr float dolly_per_notch = 0.9f;   // of the wheel
constexpr float turntable_speed = 0.6f;   // radians a second

Place& place(Session& session) {
  if (!session.view.place) session.view.place = place_of(session.camera, session.scene->bounds);
  session.requests.camera = true;
  return *session.view.place;
}

void pick_at(Session& session, const ImVec2& at, const Area& area) {
  const Ray ray = ray_through(session.camera, {at.x / area.width, at.y / area.height},
                              area.width / area.height);
  session.picked = pick(*session.scene, ray);
  session.edit_all = session.edit_all && !session.picked;
}

// The bar between the picture and the truth is dragged when it is near.
bool takes_wipe(const Session& session, const ImVec2& at, const Area& area) {
  return session.truth && session.comparing == Comparing::wipe
         && (session.report || !session.second.empty())
         && std::abs(at.x - session.wipe * area.width) < 8.0f;
}

void take_mouse(Session& session, const Area& area) {
  const ImGuiIO& io = ImGui::GetIO();
  static bool wiping = false; // from the press of the button to its release
  if (!ImGui::IsMouseDown(ImGuiMouseButton_Left)) wiping = false;
  if (io.WantCaptureMouse || io.MousePos.x >= area.width) return;
  if (takes_wipe(session, io.MousePos, area) || wiping)
    ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
  if (ImGui::IsMouseClicked(ImGuiMouseButton_Left) && takes_wipe(session, io.MousePos, area))
    wiping = true;
  if (wiping) {
    session.wipe = std::min(std::max(io.MousePos.x / area.width, 0.0f), 1.0f);
    return;
  }

  const glm::vec2 moved(io.MouseDelta.x / area.height, io.MouseDelta.y / area.height);
  const bool left = ImGui::IsMouseDragging(ImGuiMouseButton_Left),
             right = ImGui::IsMouseDragging(ImGuiMouseButton_Right),
             middle = ImGui::IsMouseDragging(ImGuiMouseButton_Middle);
  if ((left || right || middle) && moved != glm::vec2(0.0f)) {
    if (left && io.KeyCtrl) {
      session.view.env_rotation =
          std::remainder(session.view.env_rotation + 360.0f * moved.x, 360.0f);
      session.requests.light = true;
    } else if (right || io.KeyShift) {
      pan(place(session), moved);
    } else if (middle && io.KeyCtrl) {
      dolly(place(session), std::exp(2.0f * moved.y), {0.0f, 0.0f}, session.scene->bounds.radius());
    } else {
      orbit(place(session), -turn_per_height * moved.x, turn_per_height * moved.y);
    }
  }
  if (io.MouseWheel != 0.0f)
    dolly(place(session), std::pow(dolly_per_notch, io.MouseWheel),
          {(io.MousePos.x - 0.5f * area.width) / area.height, io.MousePos.y / area.height - 0.5f},
          session.scene->bounds.radius());
  // A click is a press and a release at one place.
  const ImVec2 drag = ImGui::GetMouseDragDelta(ImGuiMouseButton_Left, 0.0f);
  if (ImGui::IsMouseReleased(ImGuiMouseButton_Left)
      && std::hypot(drag.x, drag.y) < io.MouseDragThreshold)
    pick_at(session, io.MousePos, area);
}

void take_view_key(Session& session, const gpu::KeyPress& press) {
  const auto turn = [&](float yaw, float pitch) { orbit(place(session), yaw, pitch); };
  const auto closer = [&](float factor) {
    dolly(place(session), factor, {0.0f, 0.0f}, session.scene->bounds.radius());
  };
  const auto side = [&](Side from, Side opposite) {
    look_from(place(session), press.control ? opposite : from);
  };
  switch (press.key) {
  case gpu::key::left:
    return turn(-key_step, 0.0f);
  case gpu::key::right:
    return turn(key_step, 0.0f);
  case gpu::key::up:
    return turn(0.0f, key_step);
  case gpu::key::down:
    return turn(0.0f, -key_step);
  case '=':
    return closer(dolly_per_notch);
  case '-':
    return closer(1.0f / dolly_per_notch);
  case '1':
  case gpu::key::keypad_0 + 1:
    return side(Side::front, Side::back);
  case '3':
  case gpu::key::keypad_0 + 3:
    return side(Side::right, Side::left);
  case '7':
  case gpu::key::keypad_0 + 7:
    return side(Side::top, Side::bottom);
  default:
    return;
  }
}

void take_control_key(Session& session, const gpu::KeyPress& press) {
  Requests& asks = session.requests;
  switch (press.key) {
  case 'Q':
    asks.quit = true;
    return;
  case 'Z':
    (press.shift ? asks.redo : asks.undo) = true;
    return;
  case 'Y':
    asks.redo = true;
    return;
  case 'C':
    asks.copy = "capture";
    return;
  case 'S':
    asks.save_picture = "groundglass.png";
    return;
  case 'R':
    asks.reload = true;
    return;
  default:
    return;
  }
}

void take_key(Session& session, const gpu::KeyPress& press) {
  constexpr int ways = IM_ARRAYSIZE(comparing_names);
  switch (press.key) {
  case gpu::key::f11:
    session.requests.full_screen = true;
    return;
  case gpu::key::tab:
    session.panel = !session.panel;
    return;
  case gpu::key::escape:
    session.picked.reset();
    return;
  case 'F':
  case gpu::key::home:
    session.requests.frame_all = true;
    return;
  case '.':
  case gpu::key::keypad_period:
    session.requests.frame_picked = true;
    return;
  case 'R':
    session.turntable = !session.turntable;
    return;
  case 'T':
    session.truth = !session.truth;
    return;
  case 'M':
    session.comparing = static_cast<Comparing>((static_cast<int>(session.comparing) + 1) % ways);
    return;
  default:
    return;
  }
}

} // namespace

void take_input(Session& session, const Area& area, const std::vector<gpu::KeyPress>& keys,
                double seconds) {
  const bool typing = ImGui::GetIO().WantTextInput;
  session.flicker = !typing && ImGui::IsKeyDown(ImGui::GetKeyIndex(ImGuiKey_Space));
  for (const gpu::KeyPress& press : keys) {
    if (typing) break;
    if (session.scene) take_view_key(session, press);
    if (press.repeated) continue;
    if (press.control)
      take_control_key(session, press);
    else
      take_key(session, press);
  }
  if (!session.scene) return;
  take_mouse(session, area);
  if (session.turntable) orbit(place(session), turntable_speed * static_cast<float>(seconds), 0.0f);
}

const char* help() {
  return "Drag: orbit\n"
         "Shift+drag, right drag: pan\n"
         "Wheel: to and from the cursor\n"
         "Ctrl+drag: turn the environment\n"
         "Click: pick\n"
         "F: frame all        . : frame what is picked\n"
         "1 3 7: front, right, top   (Ctrl: opposite)\n"
         "Arrows, + and -: orbit, dolly\n"
         "R: turntable        Ctrl+R: reload\n"
         "T: truth beside it  M: how it is shown\n"
         "Space, held: the truth alone\n"
         "Ctrl+Z, Ctrl+Y: undo, redo\n"
         "Ctrl+C: copy the capture line\n"
         "Ctrl+S: save the picture\n"
         "Tab: panel          F11: full screen\n"
         "Ctrl+Q: quit";
}

} // namespace gg::viewer
