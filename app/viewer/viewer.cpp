#include "viewer/viewer.h"

#include "core/error.h"
#include "viewer/application.h"
#include "viewer/panels.h"

#include <algorithm>

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

} // namespace

Application::Application(const Settings& settings, const Commands& commands)
    : settings_(settings), commands_(commands), window_(gpu::create_window(settings.window)),
      picture_(std::make_unique<Picture>(window_->device())),
      warmup_(std::make_unique<Warmup>(*picture_)),
      display_(std::make_unique<DisplayPass>(window_->device())),
      loading_(commands, [this] { window_->wake(); }), truth_([this] { window_->wake(); }),
      shaders_(settings.window.backend, [this] { window_->wake(); }) {
  session_.view = settings.view;
  session_.panel = settings.panel;
  session_.frames_per_second = settings.frames_per_second;
  session_.standard_in_motion = settings.standard_in_motion;
  session_.truth = settings.truth > 0 || !settings.second.empty();
  session_.second = settings.second;
  session_.inspector = settings.inspect.has_value();
  session_.inspected_at = settings.inspect;
  session_.debug = settings.debug;
  session_.comparing = comparing_of(settings.comparing);
  session_.device = window_->device().info().name;
  session_.environments = set_up_panels(window_->scale(), thumbnails_);
}

Application::~Application() {
  truth_.stop();
}

void Application::screenshot() {
  open_first();
  const auto is_finished = [this] {
    if (!session_.scene || stale_ || quick_ || !picture_->done() || settling_ > 0) return false;
    if (!settings_.second.empty())
      return second_ && second_method_ == session_.second && second_->done();
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
