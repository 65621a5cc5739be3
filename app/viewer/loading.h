// Reading scenes and environments on a thread of its own.
#pragma once

#include "scene/coarse.h"
#include "viewer/picture.h"
#include "viewer/view.h"

#include <condition_variable>
#include <exception>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

namespace gg::viewer {

class Loading {
public:
  // `wake` is called, on the thread, when there is something to take.
  Loading(const Commands& commands, std::function<void()> wake);
  ~Loading(); // waits for what is being read

  struct Job {
    View view;
    bool scene = true;         // else the environment alone, for `current`
    bool pose = false;         // the scene alone, at another time of its animation
    int width = 1, height = 1; // of the picture that is drawn of it
    std::shared_ptr<const scene::Scene> current;
  };
  // Replaces a job that has not begun.
  void start(Job job);

  struct Done {
    View view;
    bool pose = false;
    std::shared_ptr<scene::Scene> scene;              // null if the environment alone was asked for
    std::shared_ptr<const scene::CoarseLists> coarse; // of it; null with another time of it,
    std::shared_ptr<Picture::Drawn> drawn;            // and so is this
    std::optional<environment::Map> map;              // none: no environment
    std::exception_ptr failure;                       // not null: nothing was read,
    std::string error;                                // and this is why
  };
  std::optional<Done> take();
  bool ready() const;        // there is something to take
  std::string doing() const; // the file that is being read; empty if none is, or another time of it
  bool idle() const;         // a job that is started begins at once, and nothing is there to take

private:
  void run();
  Done read(const Job& job) const;

  const Commands& commands_;
  std::function<void()> wake_;
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  std::optional<Job> next_;
  std::optional<Done> done_;
  std::string doing_;
  bool reading_ = false;
  bool stopping_ = false;
  std::thread thread_;
};

} // namespace gg::viewer
