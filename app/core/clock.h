#pragma once
// The clock that durations are measured on.
#include <chrono>

namespace gg {

using Clock = std::chrono::steady_clock;

// From `start` until now.
inline double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

// Milliseconds.
inline double ms_since(Clock::time_point start) {
  return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

} // namespace gg
