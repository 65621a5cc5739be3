// What is done between two frames of the window: the still picture, a pass at a time, and then what may be needed next. An event is
// answered after the pass that it comes in.
#include "core/clock.h"
#include "viewer/application.h"

#include <algorithm>
#include <numbers>

namespace gg::viewer {
namespace {

constexpr double still_after_ms = 150.0;  // since the last change
constexpr double still_slice_ms = 20.0;   // between two samples that are shown
constexpr double compile_slice_ms = 50.0; // between two looks at what goes on
constexpr double warmup_slice_ms = 250.0; // between two looks at what goes on

// One material changed by what a slider may reach: each to the other side of where other shaders begin.
std::vector<scene::Material> changed_by_sliders(const scene::Material& m) {
  std::vector<scene::Material> all;
  const auto with = [&](auto change) {
    all.push_back(m);
    change(all.back());
  };
  with([&](scene::Material& c) { // the other of smooth and rough
    c.exact_alpha = scene::microfacet_alpha(m) == 0.0f && !(m.back_alpha > 0.0f) ? 0.2f : 0.0f;
    c.back_alpha.reset();
  });
  if (m.conductor) return all;
  with([&](scene::Material& c) { c.clearcoat = m.clearcoat > 0.0f ? 0.0f : 1.0f; });
  with([&](scene::Material& c) {
    c.iridescence = m.iridescence > 0.0f ? 0.0f : 1.0f;
    c.iridescence_thickness = glm::max(m.iridescence_thickness, glm::vec2(1.0f));
  });
  if (!needs::is_refractive(m)) return all;
  with([&](scene::Material& c) { c.dispersion = m.dispersion > 0.0f ? 0.0f : 0.1f; });
  if (m.thickness > 0.0f)
    with([&](scene::Material& c) { // the other of clear and absorbing
      const bool clear =
          !std::isfinite(m.attenuation_distance) || m.attenuation_color == glm::vec3(1.0f);
      c.attenuation_color = glm::vec3(clear ? 0.5f : 1.0f);
      c.attenuation_distance = clear ? 1.0f : m.attenuation_distance;
    });
  return all;
}

} // namespace

void Application::see_events() {
  if (window_->event_count() != events_seen_) settling_ = 3; // panels take two frames to answer
  events_seen_ = window_->event_count();
}

bool Application::is_called() {
  window_->poll_events();
  return window_->event_count() != events_seen_ || window_->should_close() || loading_.ready()
         || truth_.ready() || shaders_.ready();
}

bool Application::is_moving() const {
  return ms_since(changed_) < still_after_ms;
}

void Application::work() {
  if (is_amid_quick() && (is_moving() || !compiling_.done)) return; // in the next frame
  if (is_moving() && picture_->is_open() && compiling_.done) { // the first picture does not move
    const bool goes_on = stale_ || session_.turntable || session_.playing || settling_ > 0;
    if (!goes_on) window_->wait_events(1e-3 * still_after_ms - seconds_since(changed_));
    return;
  }
  if ((stale_ || quick_) && !compiling_.done && picture_->is_open()) return compile();
  if (stale_ || quick_) restart(false);
  if (!picture_->done()) return draw_still(*picture_, session_.first_ms);
  set_second();
  if (second_ && !second_->done()) return draw_still(*second_, session_.second_ms);
  if (!settings_.screenshot_window.empty()) return;
  if (!planned_) plan_warmup();
  warm_up();
}

// One pipeline after another, so that the window answers meanwhile; it shows a coarse picture.
void Application::compile() {
  const auto start = Clock::now();
  if (!compiling_.begun) {
    compiling_.left =
        picture_->missing(frame_desc(1.0, session_.view.samples, session_.view.method), nullptr);
    compiling_.all = compiling_.left.size();
    compiling_.begun = true;
  }
  while (!compiling_.left.empty() && ms_since(start) < compile_slice_ms && !is_called()) {
    picture_->make(compiling_.left.back());
    compiling_.left.pop_back();
  }
  compiling_.done = compiling_.left.empty();
  settling_ = std::max(settling_, 1); // to be said
}

// The least of a picture's samples tells what one takes: others wait for other work.
void Application::draw_still(Picture& picture, double& sample_ms) {
  const auto start = Clock::now();
  // What is shown is not drawn into before it is replaced.
  const gpu::TextureRef& shown = picture.texture();
  const bool may_stop = picture.drawn() > 0 || !shown || shown->desc.width != picture.desc().width;
  do {
    const auto before = Clock::now();
    if (!picture.amid_sample()) pass_ms_.clear();
    picture.draw_pass(session_.pass_table ? &pass_ms_ : nullptr);
    window_->device().finish();
    sample_spent_ += ms_since(before);
    if (!picture.amid_sample()) {
      sample_ms = picture.drawn() == 1 ? sample_spent_ : std::min(sample_ms, sample_spent_);
      sample_spent_ = 0.0;
      session_.pass_ms = pass_ms_;
      settling_ = std::max(settling_, 1); // to be shown
      if (ms_since(start) >= still_slice_ms) break;
    }
  } while (!picture.done() && !(may_stop && is_called()));
  pace_.want(session_.frames_per_second, window_ms_);
  if (picture.done()) pace_.begin(session_.first_ms);
}

void Application::warm_up() {
  const auto start = Clock::now();
  while (!warmup_->done() && ms_since(start) < warmup_slice_ms && !is_called()) {
    warmup_->advance();
    window_->device().finish();
  }
  warmup_->pause();
}

// Turns about the target, from as high, higher and lower, at the size drawn in motion and those beside it; then what sliders of the
// chosen materials may ask for.
void Application::plan_warmup() {
  planned_ = true;
  std::vector<WarmupFrame> frames;
  struct Quick {
    double scale;
    std::string method;
    bool now; // the one that a turn begins with
  };
  const auto add = [&](const scene::Camera& camera, const Quick& quick, bool draw,
                       std::shared_ptr<const Picture::Materials> materials = nullptr) {
    WarmupFrame frame{frame_desc(quick.scale, 1, quick.method), std::move(materials), draw};
    frame.desc.camera = camera;
    frames.push_back(std::move(frame));
  };
  std::vector<Quick> quick;
  const auto add_sizes = [&](const Pace& pace, const std::string& method, double third) {
    constexpr double beside = std::numbers::sqrt2;
    for (const double factor : {1.0, 1.0 / beside, third})
      quick.push_back({std::clamp(factor * pace.scale(), 0.125, 1.0), method, factor == 1.0});
  };
  add_sizes(pace_, session_.view.method, std::numbers::sqrt2);
  if (session_.standard_in_motion && session_.view.method != standard_method)
    add_sizes(standard_pace_, standard_method, 0.5); // begun with before its speed is known
  for (const Quick& each : quick)
    add(session_.camera, each, true);
  for (const Picture::Materials& materials : materials_to_come())
    add(session_.camera, quick[0], false, std::make_shared<Picture::Materials>(materials));
  constexpr int around = 12;
  constexpr float step = 2.0f * std::numbers::pi_v<float> / around, tilt = 0.4f;
  View view = session_.view;
  for (const float pitch : {0.0f, tilt, -tilt})
    for (int i = 0; i < around; ++i) {
      view.place = session_.view.place.value_or(place_of(session_.camera, session_.scene->bounds));
      orbit(*view.place, step * static_cast<float>(i), pitch);
      const scene::Camera camera = commands_.camera(view, *session_.scene, width_, height_);
      for (const Quick& each : quick) // other targets, where other things are seen
        add(camera, each, pitch == 0.0f && each.now);
    }
  warmup_->plan(std::move(frames));
}

std::vector<Picture::Materials> Application::materials_to_come() const {
  std::vector<Picture::Materials> all;
  const std::vector<scene::Index> chosen = chosen_materials(session_);
  if (chosen.empty()) return all;
  const auto first = static_cast<std::size_t>(chosen.front());
  const auto& materials = session_.scene->materials;
  for (const scene::Material& changed : changed_by_sliders(materials[first])) {
    all.push_back(materials);
    all.back()[first] = changed;
  }
  return all;
}

} // namespace gg::viewer
