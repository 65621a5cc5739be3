// What panels and keys ask for, done.
#include "core/error.h"
#include "frame/display.h"
#include "image/image.h"
#include "viewer/application.h"
#include "viewer/save_materials.h"

#include <fmt/core.h>
#include <glm/trigonometric.hpp>
#include <imgui.h>

#include <cstdio>
#include <utility>

namespace gg::viewer {

void Application::carry_out() {
  const Requests asks = std::exchange(session_.requests, {});
  if (asks.quit) window_->close();
  if (asks.full_screen) window_->set_full_screen(!window_->is_full_screen());
  if (!asks.open.empty()) open(asks.open);
  if (!session_.scene) return;
  if (asks.reload) open(session_.view.scene);
  try {
    bool materials = asks.materials;
    if (asks.undo || asks.redo) {
      session_.view.edits = asks.undo ? session_.history.undo() : session_.history.redo();
      materials = true;
    }
    if (materials) change_materials();
    // A slider that is held is one change.
    if (!ImGui::IsAnyItemActive()) session_.history.note(session_.view.edits);
    if (asks.frame_all || (asks.frame_picked && session_.picked)) {
      if (!session_.view.place)
        session_.view.place = place_of(session_.camera, session_.scene->bounds);
      viewer::frame(*session_.view.place,
                    asks.frame_all ? session_.scene->bounds
                                   : bounds_of(*session_.scene, session_.picked->instance),
                    static_cast<float>(width_) / static_cast<float>(height_));
    }
    if (asks.pose || posing_) pose();
    const bool camera = asks.camera || asks.frame_all || asks.frame_picked;
    if (camera) session_.camera = commands_.camera(session_.view, *session_.scene, width_, height_);
    if (asks.light)
      picture_->set_light(glm::radians(session_.view.env_rotation), session_.view.env_intensity);
    if (camera || materials || asks.light || asks.quality) {
      truth_.cancel();
      session_.report.reset();
      if (asks.quality) forget_speed();
      camera_alone_ = camera && !materials && !asks.light && !asks.quality;
      stale_ = true;
      changed_ = Clock::now();
    }
    if (!asks.copy.empty()) copy(asks.copy);
    if (!asks.save_picture.empty()) save_picture(asks.save_picture);
    if (!asks.save_materials.empty()) {
      save_materials(session_.view, *session_.scene, asks.save_materials);
      session_.said = "saved " + asks.save_materials;
    }
  } catch (const Error& error) {
    session_.message = error.what();
  }
}

void Application::change_materials() {
  truth_.stop(); // it reads them
  sight_.reset();
  const std::size_t streams = session_.scene->streams.size();
  try {
    apply_edits(session_);
  } catch (const Error&) {
    session_.view.edits = session_.history.now();
    apply_edits(session_);
    throw;
  }
  if (session_.scene->streams.size() == streams) return;
  picture_->pose(session_.scene); // what is brushed has got tangents
  second_.reset();
  second_method_.clear();
}

std::string Application::words(const std::string& command, const std::string& output) const {
  return "groundglass " + commands_.words(command, session_.view, width_, height_, output);
}

void Application::copy(const std::string& command) {
  const std::string output = command == "capture" ? "capture.png"
                             : command == "truth" ? "truth.exr"
                                                  : "report";
  const std::string line = words(command, output);
  ImGui::SetClipboardText(line.c_str());
  fmt::print("{}\n", line);
  std::fflush(stdout);
  session_.said = "copied the " + command + " line";
}

void Application::save_picture(const std::string& path) {
  if (!image::is_writable_extension(path))
    throw Error(ExitCode::usage, path, "has an extension that is not known",
                "Write .png or .jpg (for display), or .exr, .hdr or .pfm (linear radiance).");
  if (stale_ || quick_) restart(false);
  while (!picture_->done())
    picture_->draw_sample();
  image::Image picture = picture_->read();
  if (image::is_display_extension(path))
    picture = frame::for_display(picture, session_.view.exposure,
                                 frame::parse_tone_map(session_.view.tonemap));
  image::write(path, picture);
  fmt::print("{}\n", words("capture", path));
  std::fflush(stdout);
  session_.said = "saved " + path;
}

} // namespace gg::viewer
