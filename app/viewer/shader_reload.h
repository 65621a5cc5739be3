// The files of shaders/, compiled again on a thread of its own when one of them is saved.
#pragma once

#include "core/clock.h"
#include "gpu/device.h"
#include "viewer/watched_files.h"

#include <condition_variable>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

namespace gg::viewer {

class ShaderReload {
public:
  // `wake` is called, on the thread, when there is something to take.
  ShaderReload(gpu::Backend backend, std::function<void()> wake);
  ~ShaderReload(); // waits for what is being compiled
  ShaderReload(const ShaderReload&) = delete;
  ShaderReload& operator=(const ShaderReload&) = delete;

  // Looks at the files, not more often than twice a second.
  void look();

  struct Done {
    int compiled = 0;   // stages: pipelines made from now on are of the new text
    std::string failed; // not empty: file, line and the compiler's words; nothing has changed
  };
  std::optional<Done> take();
  bool ready() const;

private:
  void run();

  gpu::Backend backend_;
  std::function<void()> wake_;
  WatchedFiles files_;
  Clock::time_point looked_;
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  bool wanted_ = true; // to begin with: the text that there is becomes known
  bool stopping_ = false;
  std::optional<Done> done_;
  std::thread thread_; // last: it uses the others
};

} // namespace gg::viewer
