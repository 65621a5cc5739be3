// The loop: what makes a frame, and when there is none to make.
#include "core/clock.h"
#include "viewer/application.h"
#include "viewer/input.h"
#include "viewer/panels.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>

namespace gg::viewer {

void Application::loop() {
  open_first();
  while (!window_->should_close()) {
    wait();
    if (window_->should_close()) break;
    frame();
  }
}

bool Application::is_busy() const {
  if (settling_ > 0 || building_ || session_.playing || loading_.ready() || truth_.ready()
      || shaders_.ready() || session_.turntable)
    return true;
  if (!session_.scene || broken_) return false;
  return stale_ || quick_ || !picture_->done()
         || (second_ && !second_method_.empty() && !second_->done()) || !planned_
         || !warmup_->done();
}

// An idle window waits for events and costs nothing but a look at its files once a second.
void Application::wait() {
  constexpr double between_looks = 1.0; // seconds
  window_->poll_events();
  see_events();
  while (!window_->should_close() && (!is_busy() || window_->width() == 0)) {
    window_->wait_events(between_looks);
    see_events();
    if (const std::string path = files_.changed(); !path.empty()) open(path);
    shaders_.look();
    if (loading_words() != session_.loading) break; // to be said
  }
}

std::string Application::loading_words() const {
  if (building_)
    return fmt::format("prefiltering {}: {:.0f} %", lit_->map->name, 100.0 * building_->progress());
  const std::string file = loading_.doing();
  return file.empty() ? "" : "reading " + file + " ...";
}

void Application::frame() {
  if (settling_ > 0) --settling_;
  take_loaded();
  build_light();
  take_truth();
  shaders_.look();
  take_shaders();
  for (const std::string& path : window_->take_dropped())
    open(path);
  session_.loading = loading_words();

  see_events();
  const auto began = Clock::now();
  window_->begin_frame();
  const ImGuiIO& io = ImGui::GetIO();
  // Dear ImGui's coordinates may be coarser than pixels.
  const glm::vec2 pixels(io.DisplayFramebufferScale.x, io.DisplayFramebufferScale.y);
  const float width = std::max(io.DisplaySize.x - panel_width(session_, window_->scale()), 1.0f);
  const int wanted_width = std::max(1, static_cast<int>(std::lround(width * pixels.x)));
  const int wanted_height = std::max(1, window_->height());
  if (wanted_width != width_ || wanted_height != height_) {
    width_ = wanted_width, height_ = wanted_height;
    session_.requests.camera |= session_.scene != nullptr;
  }
  inspect();
  const std::vector<gpu::KeyPress> keys = window_->take_keys();
  session_.entered = std::ranges::any_of(keys, [](const gpu::KeyPress& press) {
    return press.key == gpu::key::enter || press.key == gpu::key::keypad_enter;
  });
  draw_panels(session_, commands_.methods, window_->scale());
  const auto now = Clock::now();
  take_input(session_, {width, io.DisplaySize.y}, keys, window_->take_drags(),
             std::chrono::duration<double>(now - last_frame_).count());
  play(std::chrono::duration<double>(now - last_frame_).count());
  last_frame_ = now;
  carry_out();
  const auto drew = Clock::now();
  if (session_.scene && !broken_) attempt([this] { draw(); });
  const double drawing = ms_since(drew);
  run_truth();
  const gpu::TextureRef shown = compose();
  window_->present(shown);
  window_ms_ = ms_since(began) - drawing;
  if (session_.scene && !broken_) attempt([this] { work(); });
}

} // namespace gg::viewer
