// --bench-orbit: what a frame costs while something moves.
#include "core/clock.h"
#include "core/error.h"
#include "needs/features.h"
#include "viewer/application.h"
#include "viewer/panels.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <numbers>

namespace gg::viewer {
namespace {

// Nearest ranks.
nlohmann::json distribution_of(std::vector<double> ms) {
  std::ranges::sort(ms);
  const auto rank = [&](std::size_t percent) { return ms[(ms.size() * percent + 99) / 100 - 1]; };
  return {{"p50", rank(50)}, {"p95", rank(95)}, {"worst", ms.back()}};
}

// The first material of glass, else the first.
scene::Index slid_material(const scene::Scene& scene) {
  const auto found = std::ranges::find_if(
      scene.materials, [](const scene::Material& m) { return needs::is_refractive(m); });
  return found == scene.materials.end()
             ? 0
             : static_cast<scene::Index>(found - scene.materials.begin());
}

} // namespace

// Frames in which `change` changes something before the picture is drawn. `i` counts them.
nlohmann::json Application::bench_frames(int count, bool paced,
                                         const std::function<void(int)>& change) {
  std::vector<double> frames, pictures, answers;
  Clock::time_point changed = Clock::now();
  const gpu::DeviceCounters before = window_->device().counters();
  for (int i = 0; i < count;) {
    if (window_->should_close())
      throw Error(ExitCode::interrupted, "--bench-orbit", "the window was closed");
    window_->poll_events();
    const auto start = Clock::now();
    window_->begin_frame();
    draw_panels(session_, commands_.methods, window_->scale());
    if (!paced || !is_amid_quick()) { // the same pictures however many parts each takes
      changed = start;
      change(i);
      stale_ = true;
      camera_alone_ = !session_.picked;
    }
    const auto draw = Clock::now();
    if (paced) {
      draw_quick();
    } else {
      picture_->set(frame_desc(1.0, 1, session_.view.method), false);
      picture_->draw_sample();
      window_->device().finish();
    }
    pictures.push_back(ms_since(draw));
    window_->present(compose());
    window_->device().finish();
    frames.push_back(ms_since(start));
    if (is_amid_quick()) continue;
    answers.push_back(ms_since(changed));
    ++i;
  }
  const std::size_t count_of_frames = frames.size();
  const gpu::DeviceCounters after = window_->device().counters();
  const std::uint64_t compiled = after.compiled - before.compiled;
  return {{"frame_ms", distribution_of(std::move(frames))},
          {"picture_ms", distribution_of(std::move(pictures))},
          {"frames", count_of_frames},
          {"answer_ms", distribution_of(std::move(answers))},
          {"compiled", compiled},
          {"resources_created", after.created - before.created + compiled}};
}

// Each twice: what is seen for the first time may have to be made, and is kept.
void Application::bench() {
  int count = settings_.bench_orbit;
  open_first();
  const auto rest = [this] {
    while (!session_.scene || is_busy()) {
      if (!session_.scene) window_->wait_events(0.05);
      frame();
    }
  };
  rest();
  nlohmann::json result = {{"frames", count},
                           {"width", width_},
                           {"height", height_},
                           {"backend", window_->device().info().backend},
                           {"device", window_->device().info().name},
                           {"method", session_.view.method}};
  const auto turn = [&](int) { // all frames together once about the target
    if (!session_.view.place)
      session_.view.place = place_of(session_.camera, session_.scene->bounds);
    orbit(*session_.view.place, 2.0f * std::numbers::pi_v<float> / static_cast<float>(count), 0.0f);
    session_.camera = commands_.camera(session_.view, *session_.scene, width_, height_);
  };
  const scene::Index material = slid_material(*session_.scene);
  const auto slide = [&](int i) {
    edit_of(session_.view, material).set("alpha", fmt::format("{}", 0.1 + 0.2 * i / count));
    change_materials();
  };
  const auto twice = [&](bool paced, const std::function<void(int)>& change) {
    const nlohmann::json first = bench_frames(count, paced, change);
    nlohmann::json second = bench_frames(count, paced, change);
    second["first_time"] = first;
    return second;
  };
  result["paced"] = twice(true, turn);
  result["paced"]["scale"] = session_.scale;
  result["paced"]["method"] = session_.moving_method;
  for (std::size_t i = 0; i < session_.scene->instances.size() && !session_.picked;
       ++i) // as a user does before a slider is there
    for (const scene::Primitive& primitive :
         session_.scene->meshes[static_cast<std::size_t>(session_.scene->instances[i].mesh)]
             .primitives)
      if (primitive.material == material)
        session_.picked = Picked{.instance = static_cast<scene::Index>(i), .material = material};
  rest();
  result["slider"] = twice(true, slide);
  result["slider"]["scale"] = session_.scale;
  count = std::max(count / 10, 1); // which a software device takes a second for, each
  result["full"] = twice(false, turn);
  result["full"]["frames"] = count;
  commands_.write_times(result);
}

} // namespace gg::viewer
