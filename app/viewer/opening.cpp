// From a path to what is shown.
#include "core/cache_directory.h"
#include "core/error.h"
#include "core/files.h"
#include "environment/map.h"
#include "viewer/application.h"
#include "viewer/panels.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <thread>
#include <utility>

namespace gg::viewer {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t most_recent = 12;

std::optional<fs::path> recent_file() {
  const auto directory = cache_directory();
  return directory ? std::optional(*directory / "recent-scenes") : std::nullopt;
}

// Most recent first; none where there is no such file.
std::vector<std::string> recent_scenes() {
  std::vector<std::string> scenes;
  if (const auto file = recent_file()) {
    std::ifstream in(*file);
    for (std::string line; std::getline(in, line) && scenes.size() < most_recent;)
      if (!line.empty()) scenes.push_back(line);
  }
  return scenes;
}

} // namespace

void Application::open(const std::string& path) {
  Loading::Job job{.view = session_.view,
                   .scene = true,
                   .width = std::max(width_, 1),
                   .height = std::max(height_, 1),
                   .current = session_.scene};
  if (environment::is_map_file(path)) {
    if (!session_.scene) return;
    job.view.env = path;
    job.scene = false;
  } else if (path != session_.view.scene) { // else it is read again, with what has been done to it
    job.view.scene = path;
    job.view.materials.clear();
    job.view.edits.clear();
    job.view.camera.clear();
    job.view.place.reset();
    job.view.time.reset();
    job.view.animation.clear();
  }
  loading_.start(std::move(job));
  settling_ = 3;
}

void Application::open_first() {
  session_.recent = recent_scenes();
  const float panels = panel_width(session_, window_->scale());
  loading_.start({.view = session_.view,
                  .scene = true,
                  .width = std::max(window_->width() - static_cast<int>(panels), 1),
                  .height = std::max(window_->height(), 1),
                  .current = nullptr});
}

void Application::take_loaded() {
  if (is_amid_quick()) return; // it is of the scene before
  auto done = loading_.take();
  if (!done) return;
  settling_ = 3;
  if (done->failure) {
    if (!session_.scene) std::rethrow_exception(done->failure); // there is nothing to go on with
    session_.message = done->error;
    return;
  }
  if (done->pose) return adopt_pose(std::move(*done));
  building_.reset(); // of what was asked for before
  lit_ = std::move(done);
  try {
    if (lit_->map)
      building_ = std::make_unique<environment::Building>(window_->device(), *lit_->map);
    else
      adopt(*std::exchange(lit_, std::nullopt));
  } catch (const Error& error) {
    fail(error);
  }
}

// The picture goes on as it was until the new light is there.
void Application::build_light() {
  if (!building_) return;
  try {
    // Before the first picture there is none to go on with: then the work goes on for a while, and threads that work for it are
    // given a little time.
    constexpr auto first_slice = std::chrono::milliseconds(100);
    const auto start = Clock::now();
    bool done = building_->advance();
    while (!done && !session_.scene && Clock::now() - start < first_slice) {
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
      done = building_->advance();
    }
    if (!done) return;
    adopt(*std::exchange(lit_, std::nullopt));
  } catch (const Error& error) {
    fail(error);
  }
  building_.reset();
  settling_ = 3;
}

void Application::fail(const Error& error) {
  if (!session_.scene) throw; // there is nothing to go on with
  lit_.reset();
  session_.message = error.what();
}

void Application::adopt(Loading::Done done) {
  truth_.stop();
  warmup_->forget();
  session_.report.reset();
  auto map = done.map ? std::make_shared<const environment::Map>(std::move(*done.map)) : nullptr;
  picture_->light(building_ ? std::make_shared<const environment::Stack>(building_->stack())
                            : nullptr);
  session_.map = std::move(map);
  if (done.scene) {
    const bool again = done.view.scene == session_.view.scene && session_.scene;
    session_.scene = std::move(done.scene);
    session_.file_materials = session_.scene->materials;
    if (!again) session_.history = {};
    session_.picked.reset();
    outlined_.reset();
    display_->pick(*session_.scene, scene::none);
    // Edits that the file is opened with again may turn a metal into glass.
    if (!std::ranges::all_of(session_.view.edits, &Edit::empty)) done.drawn->shapes.reset();
    picture_->open(session_.scene, std::move(done.drawn), std::move(done.coarse));
    forget_speed();
    debug_.reset(); // it draws the scene before
    sight_.reset();
    debug_shown_.reset();
    session_.playing = false;
    second_.reset(); // and so does this
    second_method_.clear();
  }
  const Edits edits = session_.view.edits; // may be newer than the job's
  const bool same = done.view.scene == session_.view.scene;
  session_.view.scene = done.view.scene;
  session_.view.env = done.view.env;
  if (!same) session_.view = done.view;
  if (same) session_.view.edits = edits;
  try {
    apply_edits(session_);
  } catch (const Error& error) { // the file has other materials now
    session_.message = error.what();
    session_.view.edits.clear();
    apply_edits(session_);
  }
  session_.message.clear();
  session_.requests.camera = session_.requests.light = true;
  files_.watch({session_.view.scene, session_.view.env});
  window_->set_title(fs::path(session_.view.scene).filename().string() + " - Groundglass");
  remember(session_.view.scene);
}

// The same file at another time.
void Application::adopt_pose(Loading::Done done) {
  if (done.view.scene != session_.view.scene || !done.scene) return; // another has come meanwhile
  truth_.stop();
  warmup_->forget();
  session_.report.reset();
  done.scene->materials = session_.scene->materials;
  session_.scene = std::move(done.scene);
  picture_->pose(session_.scene);
  debug_.reset();
  sight_.reset();
  second_.reset();
  second_method_.clear();
  outlined_.reset();
  session_.requests.camera = true;
}

// Time goes on by the clock; poses that take longer are left out.
void Application::play(double seconds) {
  if (!session_.playing || !session_.scene) return;
  View& view = session_.view;
  const auto& posed = session_.scene->posed;
  const float end = posed ? posed->end : 0.0f;
  view.time = view.time.value_or(0.0f) + static_cast<float>(seconds);
  if (posed && *view.time > end) view.time = end > 0.0f ? std::fmod(*view.time, end) : 0.0f;
  session_.requests.pose = true;
}

void Application::pose() {
  // A camera that is framed by what it sees would move with it: as in `capture --frames-out`.
  if (!session_.view.place && session_.scene->cameras.empty())
    session_.view.place = place_of(session_.camera, session_.scene->bounds);
  if (!loading_.idle()) {
    posing_ = true; // when it is
    return;
  }
  posing_ = false;
  loading_.start({.view = session_.view, .scene = true, .pose = true, .current = session_.scene});
}

void Application::remember(const std::string& scene) {
  std::error_code none;
  const std::string path = fs::absolute(scene, none).string();
  if (recent_file()) session_.recent = recent_scenes(); // with what other windows have opened since
  std::erase(session_.recent, path);
  session_.recent.insert(session_.recent.begin(), path);
  session_.recent.resize(std::min(session_.recent.size(), most_recent));
  const auto file = recent_file();
  if (!file) return;
  try { // a list that cannot be kept is no reason to stop
    fs::create_directories(file->parent_path());
    OutputFile out(*file);
    for (const std::string& line : session_.recent)
      out.write(line + "\n");
    out.commit();
  } catch (const std::exception&) {
  }
}

} // namespace gg::viewer
