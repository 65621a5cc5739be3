// The picture, the truth beside it, and both on the screen.
#include "core/clock.h"
#include "core/error.h"
#include "image/heat_map.h"
#include "needs/left_out.h"
#include "viewer/application.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

namespace gg::viewer {
namespace {

constexpr float outline_width = 2.0f;

// Display-encoded colours of a one-channel map.
image::Image coloured(const image::Image& map, double top) {
  image::Image colours(map.width, map.height, 3);
  for (std::size_t i = 0; i < map.values.size(); ++i) {
    const auto colour = image::heat_colour(static_cast<double>(map.values[i]) / top);
    std::ranges::copy(colour, colours.values.begin() + static_cast<std::ptrdiff_t>(3 * i));
  }
  return colours;
}

// As `groundglass needs` lists them. What passes of one label write together counts once.
std::vector<Session::PassRow> rows_of(const frame::Graph& graph) {
  std::vector<Session::PassRow> rows;
  std::set<std::pair<std::string, std::size_t>> counted;
  for (const frame::Pass& pass : graph.passes) {
    auto row = std::ranges::find(rows, pass.label, &Session::PassRow::label);
    if (row == rows.end()) row = rows.insert(rows.end(), {.label = pass.label});
    ++row->passes;
    row->draws += pass.draws;
    const auto count = [&](std::size_t target) {
      if (counted.emplace(pass.label, target).second)
        row->bytes += frame::bytes_of(graph.targets[target]);
    };
    for (const frame::ColorOutput& color : pass.colors)
      count(color.part.target);
    if (pass.depth) count(pass.depth->target);
  }
  return rows;
}

} // namespace

// Another method stands in until the session's is compiled, and where nothing but the camera moves: who turns a slider looks at
// what it does.
bool Application::is_by_standard() const {
  return session_.standard_in_motion && session_.debug == DebugKind::picture
         && (!compiling_.done || (camera_alone_ && pace_.is_out_of_reach()));
}

const std::string& Application::quick_method() const {
  return is_by_standard() ? standard_method : session_.view.method;
}

void Application::forget_speed() {
  constexpr int a_quarter = 4;
  compiling_ = {};
  pace_ = Pace();
  standard_pace_ = Pace(a_quarter);
}

frame::FrameDesc Application::frame_desc(double scale, int samples,
                                         const std::string& method) const {
  const auto side = [&](int full) {
    return std::max(1, static_cast<int>(std::lround(scale * full)));
  };
  return {.width = scale == 1.0 ? width_ : side(width_),
          .height = scale == 1.0 ? height_ : side(height_),
          .samples = samples,
          .camera = session_.camera,
          .method = commands_.method(method),
          .correlated_smith = session_.view.smith == "correlated",
          .multiple_scattering = session_.view.multiscatter,
          .without = needs::left_out(session_.view.without),
          .background = commands_.background(session_.view)};
}

void Application::restart(bool quick) {
  if (quick) session_.scale = (is_by_standard() ? standard_pace_ : pace_).scale();
  const frame::FrameDesc desc = quick
                                    ? frame_desc(session_.scale, 1, quick_method())
                                    : frame_desc(1.0, session_.view.samples, session_.view.method);
  picture_->set(desc, !quick);
  display_->see(session_.camera, width_, height_, outline_width * window_->scale(), quick);
  debug_shown_.reset();
  stale_ = false;
  quick_ = quick;
  planned_ = false;
  sample_spent_ = 0.0;
  compared_ = false;
  compiling_.begun = compiling_.done; // else what is missing is to be looked up again
}

bool Application::is_amid_quick() const {
  return quick_ && !broken_ && picture_->is_open() && picture_->amid_sample();
}

// What takes longer than a frame is drawn in several, and the window answers in each; changes that come meanwhile wait for the next
// picture, so that each is finished. A camera that is turned does not wait for a slider's picture.
void Application::draw_quick() {
  const auto start = Clock::now();
  Pace& pace = is_by_standard() ? standard_pace_ : pace_;
  const bool goes_on = is_amid_quick() && (!stale_ || session_.moving_method == quick_method());
  if (!goes_on) {
    quick_is_first_ = !picture_->is_open(); // its time is that of compiling
    quick_ms_ = 0.0;
    session_.moving_method = quick_method();
    restart(true);
  }
  for (Pace* of : {&pace_, &standard_pace_})
    of->want(session_.frames_per_second, window_ms_);
  // Only where what was shown before can be shown meanwhile (DisplayPass::Show::being_drawn): a step below half of the width.
  const bool in_parts = pace.is_late() && session_.scale < 0.45;
  const double part_ms =
      std::max(pace.wanted_ms(), window_ms_); // a slow window leaves the picture half of the time
  double pass_ms = 0.0;                       // of the last: the next takes as much, about
  do {
    const auto before = Clock::now();
    picture_->draw_pass();
    if (in_parts) window_->device().finish();
    pass_ms = ms_since(before);
  } while (picture_->amid_sample() && !(in_parts && ms_since(start) + pass_ms > part_ms));
  window_->device().finish();
  quick_ms_ += ms_since(start);
  if (picture_->amid_sample()) return;
  session_.frame_ms = quick_ms_ + window_ms_;
  if (!quick_is_first_) pace.took(quick_ms_);
}

// Set, or let go, as the session says; drawn in work().
void Application::set_second() {
  if (!session_.truth || session_.second.empty()) {
    second_.reset();
    second_method_.clear();
    return;
  }
  if (stale_ || quick_ || !picture_->done()) {
    second_method_.clear();
    return;
  }
  if (!second_) {
    second_ = std::make_unique<Picture>(window_->device());
    second_->open_as(*picture_);
  }
  if (second_method_ != session_.second) {
    second_method_ = session_.second;
    second_->light_as(*picture_);
    second_->set(frame_desc(1.0, session_.view.samples, second_method_), true);
  }
}

// A shader that was saved may compile and yet not fit what is drawn with it.
void Application::attempt(const std::function<void()>& drawing) {
  try {
    drawing();
  } catch (const Error& error) {
    if (!reloaded_) throw;
    session_.shader_message = error.what();
    broken_ = true;
  }
}

void Application::draw() {
  // The first picture is a coarse one, while the other method is compiled.
  session_.moving = is_moving() && (picture_->is_open() || is_by_standard());
  session_.compiled =
      compiling_.done || compiling_.all == 0
          ? 1.0
          : 1.0 - static_cast<double>(compiling_.left.size()) / static_cast<double>(compiling_.all);
  const scene::Index picked = session_.picked ? session_.picked->instance : scene::none;
  if (outlined_ != picked) {
    display_->pick(*session_.scene, picked);
    display_->see(session_.camera, width_, height_, outline_width * window_->scale(), quick_);
    outlined_ = picked;
    planned_ = false; // its sliders may be next
  }
  if ((session_.moving && stale_) || is_amid_quick()) draw_quick();
  set_second();
  session_.drawn = picture_->drawn();
  session_.device_bytes = window_->device().memory_bytes();
  timing_asked_ &= session_.pass_table;
  if (!session_.pass_table || !picture_->is_open()) return;
  if (!timing_asked_ && session_.pass_ms.empty() && picture_->done() && !quick_)
    stale_ = timing_asked_ = true; // again, for its passes were not timed
  session_.passes = rows_of(picture_->renderer().graph());
  session_.features = needs::features_in_use(picture_->renderer().needs().draws.all);
}

void Application::run_truth() {
  if (!session_.truth || !session_.second.empty()) {
    if (compared_) truth_.cancel();
    session_.report.reset();
    compared_ = false;
    return;
  }
  // It begins when the picture is finished, so that neither waits for the other.
  if (!session_.scene || stale_ || quick_ || !picture_->done() || compared_) return;
  truth_.start({.scene = session_.scene,
                .map = session_.map,
                .rotation = static_cast<double>(glm::radians(session_.view.env_rotation)),
                .intensity = static_cast<double>(session_.view.env_intensity),
                .camera = session_.camera,
                .width = width_,
                .height = height_,
                .correlated_smith = session_.view.smith == "correlated",
                .multiple_scattering = session_.view.multiscatter,
                .background = commands_.background(session_.view),
                .samples = settings_.truth > 0 ? settings_.truth : 4096});
  std::vector<int> objects;
  if (session_.picked) objects.push_back(session_.picked->instance + 1);
  truth_.compare_with(std::make_shared<const image::Image>(picture_->read()), std::move(objects));
  compared_ = true;
}

void Application::take_truth() {
  if (auto report = truth_.take()) session_.report = std::move(report);
}

// What has been drawn with the text before stays until the next sample.
void Application::take_shaders() {
  if (is_amid_quick()) return; // it goes on with those that it began with
  const auto done = shaders_.take();
  if (!done) return;
  settling_ = 3;
  session_.shader_message = done->failed;
  if (done->compiled == 0) return;
  reloaded_ = true;
  broken_ = false;
  session_.said = fmt::format("compiled {} stages again", done->compiled);
  picture_->forget_pipelines();
  compiling_ = {};
  warmup_->forget();
  second_.reset();
  second_method_.clear();
  display_ = std::make_unique<DisplayPass>(window_->device());
  debug_.reset();
  outlined_.reset();
  session_.requests.quality = true;
}

void Application::inspect() {
  session_.inspected.reset();
  const auto at = session_.inspected_at ? session_.inspected_at : session_.cursor;
  if (!session_.inspector || !session_.scene || !at || height_ == 0) return;
  const Ray ray =
      ray_through(session_.camera, *at, static_cast<float>(width_) / static_cast<float>(height_));
  session_.inspected = viewer::inspect(*session_.scene, ray, commands_.method(session_.view.method),
                                       session_.view.smith == "correlated");
}

Beside Application::debug_view() {
  if (!debug_) debug_ = std::make_unique<DebugView>(window_->device());
  if (!debug_shown_ || debug_kind_ != session_.debug) {
    DebugView::Drawn drawn;
    if (session_.debug >= DebugKind::sigma_in_pixels) {
      if (!sight_) sight_ = std::make_unique<Sight>(session_.scene);
      drawn = sight_->draw({.kind = session_.debug,
                            .camera = session_.camera,
                            .width = width_,
                            .height = height_,
                            .coarse = quick_,
                            .samples = quick_ ? 1 : session_.view.samples},
                           picture_->renderer().needs());
    } else {
      drawn = debug_->draw(session_.debug, *session_.scene, session_.camera, width_, height_);
    }
    session_.debug_greatest = drawn.greatest;
    debug_shown_ = upload(window_->device(), drawn.colours, "debug view");
    debug_kind_ = session_.debug;
  }
  return {.texture = debug_shown_, .factor = 1.0f, .encoded = true, .from = 0.0f};
}

std::optional<Beside> Application::beside() {
  if (session_.debug != DebugKind::picture && session_.scene && !session_.flicker && !stale_)
    return debug_view();
  if (session_.truth && !second_method_.empty() && second_->drawn() > 0) {
    Beside shown{.texture = second_->texture(),
                 .factor = second_->factor() * std::exp2(session_.view.exposure),
                 .from = session_.flicker ? 0.0f : session_.wipe};
    shown.side_by_side = !session_.flicker && session_.comparing == Comparing::side_by_side;
    return shown;
  }
  const auto& report = session_.report;
  if (!session_.truth || !report || !report->failed.empty()) {
    beside_.reset();
    report_shown_.reset();
    return std::nullopt;
  }
  const bool map =
      !session_.flicker && report->comparison
      && (session_.comparing == Comparing::relative_error || session_.comparing == Comparing::flip);
  const Comparing kind = map ? session_.comparing : Comparing::wipe;
  if (report_shown_ != report || beside_kind_ != kind) {
    gpu::Device& device = window_->device();
    if (!map)
      beside_ = upload(device, report->picture.colour, "truth");
    else if (kind == Comparing::flip)
      beside_ = upload(device, coloured(report->comparison->flip_map, 1.0), "FLIP");
    else
      beside_ = upload(device, coloured(report->comparison->relative_map, 1.0), "relative error");
    report_shown_ = report;
    beside_kind_ = kind;
  }
  Beside shown{.texture = beside_, .factor = std::exp2(session_.view.exposure), .from = 0.0f};
  if (map) {
    shown.factor = 1.0f;
    shown.encoded = true;
  } else if (!session_.flicker) {
    shown.side_by_side = session_.comparing == Comparing::side_by_side;
    if (session_.comparing == Comparing::wipe) shown.from = session_.wipe;
  }
  return shown;
}

gpu::TextureRef Application::compose() {
  DisplayPass::Show show{.width = std::max(window_->width(), 1),
                         .height = std::max(window_->height(), 1),
                         .picture_width = width_,
                         .picture_height = height_,
                         .tone_map = frame::parse_tone_map(session_.view.tonemap),
                         .beside = beside()};
  if (!broken_ && picture_->texture()) {
    show.picture = picture_->texture();
    show.being_drawn = picture_->hides_texture();
    show.factor = picture_->factor() * std::exp2(session_.view.exposure);
  } else {
    show.picture_width = show.picture_height = 0;
  }
  return display_->draw(show);
}

} // namespace gg::viewer
