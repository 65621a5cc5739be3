#include "viewer/viewer.h"

#include "core/error.h"
#include "viewer/application.h"
#include "viewer/panels.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <numbers>

namespace gg::viewer {
namespace {

Comparing comparing_of(const std::string& name) {
  if (name == "wipe") return Comparing::wipe;
  if (name == "side-by-side") return Comparing::side_by_side;
  if (name == "error") return Comparing::relative_error;
  if (name == "flip") return Comparing::flip;
  throw Error(ExitCode::usage, "--compare", "'" + name + "' is not known",
              "Choose wipe, side-by-side, error or flip.");
}

// Nearest ranks.
nlohmann::json distribution_of(std::vector<double> ms) {
  std::ranges::sort(ms);
  const auto rank = [&](std::size_t percent) { return ms[(ms.size() * percent + 99) / 100 - 1]; };
  return {{"p50", rank(50)}, {"p95", rank(95)}, {"worst", ms.back()}};
}

double ms_since(Clock::time_point start) {
  return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

} // namespace

Application::Application(const Settings& settings, const Commands& commands)
    : settings_(settings), commands_(commands), window_(gpu::create_window(settings.window)),
      picture_(std::make_unique<Picture>(window_->device())),
      display_(std::make_unique<DisplayPass>(window_->device())),
      loading_(commands, [this] { window_->wake(); }), truth_([this] { window_->wake(); }),
      shaders_(settings.window.backend, [this] { window_->wake(); }) {
  session_.view = settings.view;
  session_.panel = settings.panel;
  session_.frames_per_second = settings.frames_per_second;
  session_.truth = settings.truth > 0;
  session_.inspector = settings.inspect.has_value();
  session_.inspected_at = settings.inspect;
  session_.debug = settings.debug;
  session_.comparing = comparing_of(settings.comparing);
  session_.device = window_->device().info().name;
  set_up_panels(window_->scale());
}

Application::~Application() {
  truth_.stop();
}

// One turn about the target: first at full size, then at the size that keeps the rate.
void Application::bench() {
  const int count = settings_.bench_orbit;
  open_first();
  while (!session_.scene || stale_ || !picture_->is_open() || !picture_->done()) {
    if (!session_.scene) window_->wait_events(0.05);
    frame();
  }
  nlohmann::json result = {{"frames", count},
                           {"width", width_},
                           {"height", height_},
                           {"backend", window_->device().info().backend},
                           {"device", window_->device().info().name},
                           {"method", session_.view.method}};
  for (const bool paced : {false, true}) {
    std::vector<double> frames, pictures;
    constexpr int warm_up = 10; // frames: until the size has settled
    std::uint64_t created = 0;
    for (int i = -warm_up; i < count; ++i) {
      if (window_->should_close())
        throw Error(ExitCode::interrupted, "--bench-orbit", "the window was closed");
      window_->poll_events();
      const gpu::DeviceCounters before = window_->device().counters();
      const auto start = Clock::now();
      window_->begin_frame();
      draw_panels(session_, commands_.methods, window_->scale());
      if (!session_.view.place)
        session_.view.place = place_of(session_.camera, session_.scene->bounds);
      orbit(*session_.view.place, 2.0f * std::numbers::pi_v<float> / static_cast<float>(count),
            0.0f);
      session_.camera = commands_.camera(session_.view, *session_.scene, width_, height_);
      const auto draw = Clock::now();
      if (paced) {
        draw_quick();
      } else {
        picture_->set(frame_desc(1.0, 1), false);
        picture_->draw_sample();
        window_->device().finish();
      }
      const double picture_ms = ms_since(draw);
      window_->present(compose());
      window_->device().finish();
      if (i < 0) continue;
      frames.push_back(ms_since(start));
      pictures.push_back(picture_ms);
      const gpu::DeviceCounters after = window_->device().counters();
      created += after.created + after.compiled - before.created - before.compiled;
    }
    nlohmann::json& part = result[paced ? "paced" : "full"];
    part = {{"frame_ms", distribution_of(frames)},
            {"picture_ms", distribution_of(pictures)},
            {"resources_created", created}};
    if (paced) part["scale"] = session_.scale;
  }
  commands_.write_times(result);
}

void Application::screenshot() {
  open_first();
  const auto is_finished = [this] {
    if (!session_.scene || stale_ || quick_ || !picture_->done() || settling_ > 0) return false;
    return settings_.truth == 0
           || (session_.report
               && (session_.report->samples >= settings_.truth
                   || !session_.report->failed.empty()));
  };
  bool picked = settings_.pick.empty();
  while (!is_finished() || !picked) {
    if (window_->should_close())
      throw Error(ExitCode::interrupted, "--screenshot-window", "the window was closed");
    window_->wait_events(is_busy() ? 0.0 : 0.05);
    frame();
    if (!session_.scene || picked) continue;
    const auto& instances = session_.scene->instances;
    const auto found = std::ranges::find(instances, settings_.pick, &scene::Instance::name);
    if (found == instances.end())
      throw Error(ExitCode::usage, "--pick", "there is no object '" + settings_.pick + "'");
    session_.picked =
        Picked{.instance = static_cast<scene::Index>(found - instances.begin()),
               .material = session_.scene->meshes[static_cast<std::size_t>(found->mesh)]
                               .primitives.front()
                               .material};
    picked = true;
    settling_ = 3;
  }
  window_->begin_frame();
  inspect();
  draw_panels(session_, commands_.methods, window_->scale());
  std::vector<std::byte> shown;
  const int width = window_->width(), height = window_->height();
  window_->present(compose(), &shown);
  image::Image picture(width, height, 3);
  for (std::size_t i = 0; i < static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
       ++i)
    for (std::size_t c = 0; c < 3; ++c)
      picture.values[3 * i + c] = static_cast<float>(shown[4 * i + c]) / 255.0f;
  image::write(settings_.screenshot_window, picture);
}

void run(const Settings& settings, const Commands& commands) {
  Application application(settings, commands);
  if (settings.bench_orbit > 0)
    application.bench();
  else if (!settings.screenshot_window.empty())
    application.screenshot();
  else
    application.loop();
}

} // namespace gg::viewer
