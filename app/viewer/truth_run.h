// The path tracer on the view, on threads of its own.
#pragma once

#include "environment/map.h"
#include "frame/frame_desc.h"
#include "image/compare.h"
#include "image/image.h"
#include "scene/scene.h"

#include <atomic>
#include <functional>
#include <list>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

namespace gg::viewer {

class TruthRun {
public:
  explicit TruthRun(std::function<void()> wake) : wake_(std::move(wake)) {}
  ~TruthRun() { stop(); }
  TruthRun(const TruthRun&) = delete;
  TruthRun& operator=(const TruthRun&) = delete;

  struct Desc {
    std::shared_ptr<const scene::Scene> scene; // not changed while it runs
    std::shared_ptr<const environment::Map> map;
    double rotation = 0.0, intensity = 1.0; // radians
    scene::Camera camera;
    int width = 0, height = 0;
    bool correlated_smith = false, multiple_scattering = false;
    frame::Background background;
    long samples = 4096;
  };
  // Starts again; what ran before is cancelled.
  void start(Desc desc);
  void cancel(); // at once: its threads end by themselves, nothing of theirs is reported any more
  void stop();   // cancels, and returns when no thread of it reads the scene

  // The finished frame that it is compared with, linear; none: nothing is compared.
  void compare_with(std::shared_ptr<const image::Image> frame, std::vector<int> objects);

  struct Report {
    image::Picture picture; // with its standard errors and ids
    long samples = 0;
    double error = 0.0; // Film::relative_error()
    double seconds = 0.0;
    std::optional<image::Comparison> comparison;
    std::string failed; // not empty: why there is nothing
  };
  // What is new since the last call.
  std::shared_ptr<const Report> take();
  bool ready() const; // there is something to take

private:
  struct Run {
    std::atomic<bool> stop{false}, finished{false};
    std::thread thread;
  };
  void trace(Run& run, const Desc& desc);
  void publish(const Run& run, Report report);

  std::function<void()> wake_;
  std::list<Run> runs_; // the last is the current one, unless it is cancelled
  mutable std::mutex mutex_;
  std::shared_ptr<const Report> report_;
  std::shared_ptr<const image::Image> frame_;
  std::vector<int> objects_;
};

} // namespace gg::viewer
