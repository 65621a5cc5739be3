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

void pick_at(Session& session, float x, float y, const Area& area) {
  const Ray ray =
      ray_through(session.camera, {x / area.width, y / area.height}, area.width / area.height);
  session.picked = pick(*session.scene, ray);
  session.edit_all = session.edit_all && !session.picked;
}

// The bar between the picture and the second is dragged when it is near.
bool takes_wipe(const Session& session, float x, const Area& area) {
  return session.truth && session.comparing == Comparing::wipe
         && (session.report || !session.second.empty())
         && std::abs(x - session.wipe * area.width) < 8.0f;
}

void take_drag(Session& session, const gpu::Drag& drag, const Area& area) {
  constexpr int left = 0, right = 1, middle = 2;
  const glm::vec2 from(drag.from_x, drag.from_y);
  if (drag.click) {
    if (drag.button == left) pick_at(session, drag.x, drag.y, area);
    return;
  }
  if (drag.button == left && (session.wiping == from || takes_wipe(session, from.x, area))) {
    session.wiping = from;
    session.wipe = std::min(std::max(drag.x / area.width, 0.0f), 1.0f);
    return;
  }
  session.wiping.reset();
  const glm::vec2 moved = glm::vec2(drag.moved_x, drag.moved_y) / area.height;
  if (drag.button == left && drag.control) {
    session.view.env_rotation =
        std::remainder(session.view.env_rotation + 360.0f * moved.x, 360.0f);
    session.requests.light = true;
  } else if (drag.button == right || drag.shift) {
    pan(place(session), moved);
  } else if (drag.button == middle && drag.control) {
    dolly(place(session), std::exp(2.0f * moved.y), {0.0f, 0.0f}, session.scene->bounds.radius());
  } else {
    orbit(place(session), -turn_per_height * moved.x, turn_per_height * moved.y);
  }
}

void take_mouse(Session& session, const std::vector<gpu::Drag>& drags, const Area& area) {
  const ImGuiIO& io = ImGui::GetIO();
  if (io.WantCaptureMouse) return;
  if (takes_wipe(session, io.MousePos.x, area)) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
  for (const gpu::Drag& drag : drags)
    if (drag.from_x < area.width) take_drag(session, drag, area);
  if (io.MouseWheel != 0.0f && io.MousePos.x < area.width)
    dolly(place(session), std::pow(dolly_per_notch, io.MouseWheel),
          {(io.MousePos.x - 0.5f * area.width) / area.height, io.MousePos.y / area.height - 0.5f},
          session.scene->bounds.radius());
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
  case '5':
  case gpu::key::keypad_0 + 5: {
    Place& moved = place(session);
    return set_orthographic(moved, moved.ortho == 0.0f);
  }
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
  case 'P':
    session.playing = !session.playing && session.scene && !session.scene->animations.empty();
    return;
  case 'V':
    session.debug =
        static_cast<DebugKind>((static_cast<int>(session.debug) + 1) % IM_ARRAYSIZE(debug_names));
    return;
  case 'I':
    session.inspector = !session.inspector;
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
                const std::vector<gpu::Drag>& drags, double seconds) {
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
  take_mouse(session, drags, area);
  const ImGuiIO& io = ImGui::GetIO();
  const glm::vec2 cursor(io.MousePos.x / area.width, io.MousePos.y / area.height);
  const bool over = !io.WantCaptureMouse && glm::all(glm::greaterThanEqual(cursor, glm::vec2(0.0f)))
                    && glm::all(glm::lessThan(cursor, glm::vec2(1.0f)));
  if (over && session.cursor != cursor) session.inspected_at.reset();
  if (over) session.cursor = cursor;
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
         "5: orthographic    I: lobes under the cursor\n"
         "V: normals, depth, solids, lobes\n"
         "Arrows, + and -: orbit, dolly\n"
         "R: turntable        Ctrl+R: reload\n"
         "P: play the animation, pause\n"
         "T: truth beside it  M: how it is shown\n"
         "Space, held: the truth alone\n"
         "Ctrl+Z, Ctrl+Y: undo, redo\n"
         "Ctrl+C: copy the capture line\n"
         "Ctrl+S: save the picture\n"
         "Tab: panel          F11: full screen\n"
         "Ctrl+Q: quit";
}

} // namespace gg::viewer
