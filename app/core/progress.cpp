#include "core/progress.h"

#include <unistd.h>

#include <cstdio>

namespace gg {

Progress::Progress(std::string what, long total)
    : what_(std::move(what)), total_(total), terminal_(::isatty(STDERR_FILENO) != 0),
      start_(Clock::now()), drawn_() {}

Progress::~Progress() {
  if (terminal_ && drawn_ != Clock::time_point{}) std::fputs("\r\x1b[K", stderr);
}

void Progress::update(long done, const std::string& detail) {
  const auto now = Clock::now();
  if (!terminal_ || now - drawn_ < std::chrono::milliseconds(100)) return;
  drawn_ = now;
  const double seconds = std::chrono::duration<double>(now - start_).count();
  std::fprintf(stderr, "\r\x1b[K%s", what_.c_str());
  if (total_ > 0) {
    const double part = static_cast<double>(done) / static_cast<double>(total_);
    std::fprintf(stderr, "  %3.0f %%", 100.0 * part);
    // An estimate from less than a second of work would jump about.
    if (seconds > 1.0 && done > 0)
      std::fprintf(stderr, "  %.0f s left", seconds * (1.0 / part - 1.0));
  } else {
    std::fprintf(stderr, "  %ld", done);
  }
  if (!detail.empty()) std::fprintf(stderr, "  %s", detail.c_str());
  std::fflush(stderr);
}

} // namespace gg
