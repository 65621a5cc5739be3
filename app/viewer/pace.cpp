#include "viewer/pace.h"

#include <algorithm>
#include <cmath>

namespace gg::viewer {
namespace {

constexpr int most_steps = 6; // of the root of two: an eighth
constexpr int frames_to_grow = 5;

} // namespace

double Pace::scale() const {
  return std::exp2(-0.5 * step_);
}

void Pace::took(double ms) {
  // Each step halves the pixels, and a frame's time is in proportion to them at most.
  if (ms > wanted_ms_) {
    const int down = std::max(1, static_cast<int>(std::lround(std::log2(ms / wanted_ms_))));
    step_ = std::min(most_steps, step_ + down);
    in_time_ = 0;
  } else if (2.0 * ms < 0.9 * wanted_ms_ && step_ > 0) {
    if (++in_time_ >= frames_to_grow) --step_, in_time_ = 0;
  } else {
    in_time_ = 0;
  }
}

} // namespace gg::viewer
