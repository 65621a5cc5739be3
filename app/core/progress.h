// How far long work has come: one line on stderr, rewritten in place, and only on a terminal.
#pragma once

#include "core/clock.h"

#include <string>

namespace gg {

class Progress {
public:
  // `what` names the work; `total` is the number of steps, 0 if not known.
  Progress(std::string what, long total);
  ~Progress(); // clears the line
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  // `done` steps of the total are finished; `detail` is shown after them ("error 4.1 %"). Redraws
  // at most 10 times a second, so it may be called as often as is convenient. Not thread-safe.
  void update(long done, const std::string& detail = {});

private:
  std::string what_;
  long total_;
  bool terminal_;
  Clock::time_point start_, drawn_;
};

} // namespace gg
