// From a path to what is shown.
#include "core/cache_directory.h"
#include "core/error.h"
#include "core/files.h"
#include "viewer/application.h"

#include <algorithm>
#include <filesystem>
#include <fstream>

namespace gg::viewer {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t most_recent = 12;

std::optional<fs::path> recent_file() {
  const auto directory = cache_directory();
  return directory ? std::optional(*directory / "recent-scenes") : std::nullopt;
}

bool is_environment(const std::string& path) {
  const std::string extension = fs::path(path).extension();
  return extension == ".hdr" || extension == ".exr";
}

} // namespace

void Application::open(const std::string& path) {
  Loading::Job job{.view = session_.view, .scene = true, .current = session_.scene};
  if (is_environment(path)) {
    if (!session_.scene) return;
    job.view.env = path;
    job.scene = false;
  } else if (path != session_.view.scene) { // else it is read again, with what has been done to it
    job.view.scene = path;
    job.view.materials.clear();
    job.view.edits.clear();
    job.view.camera.clear();
    job.view.place.reset();
  }
  loading_.start(std::move(job));
  settling_ = 3;
}

void Application::open_first() {
  if (const auto file = recent_file()) {
    std::ifstream in(*file);
    for (std::string line; std::getline(in, line) && session_.recent.size() < most_recent;)
      if (!line.empty()) session_.recent.push_back(line);
  }
  loading_.start({.view = session_.view, .scene = true, .current = nullptr});
}

void Application::take_loaded() {
  auto done = loading_.take();
  if (!done) return;
  settling_ = 3;
  if (done->failure) {
    if (!session_.scene) std::rethrow_exception(done->failure); // there is nothing to go on with
    session_.message = done->error;
    return;
  }
  try {
    adopt(std::move(*done));
  } catch (const Error& error) {
    if (!session_.scene) throw;
    session_.message = error.what();
  }
}

void Application::adopt(Loading::Done done) {
  truth_.stop();
  session_.report.reset();
  auto map = done.map ? std::make_shared<const environment::Map>(std::move(*done.map)) : nullptr;
  picture_->light(map.get());
  session_.map = std::move(map);
  if (done.scene) {
    const bool again = done.view.scene == session_.view.scene && session_.scene;
    session_.scene = std::move(done.scene);
    session_.file_materials = session_.scene->materials;
    if (!again) session_.history = {};
    session_.picked.reset();
    outlined_.reset();
    display_->pick(*session_.scene, scene::none);
    picture_->open(session_.scene);
    debug_.reset(); // it draws the scene before
    debug_shown_.reset();
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

void Application::remember(const std::string& scene) {
  std::error_code none;
  const std::string path = fs::absolute(scene, none).string();
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
