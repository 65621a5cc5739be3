#include "viewer/pace.h"

#include <algorithm>
#include <cmath>

namespace gg::viewer {
namespace {

constexpr int most_steps = 6; // of the root of two: an eighth
constexpr int frames_to_grow = 5;

} // namespace

void Pace::want(double frames_per_second, double others_ms) {
  const double frame_ms = 1000.0 / frames_per_second;
  wanted_ms_ = std::max(frame_ms - others_ms, frame_ms / 3.0);
}

void Pace::begin(double full_ms) {
  if (begun_) return;
  lowest_ms_ = full_ms * std::exp2(-most_steps); // at least
  // To the next step, so that the first frame is in time.
  step_ = std::clamp(static_cast<int>(std::ceil(std::log2(full_ms / wanted_ms_))), 0, most_steps);
}

double Pace::scale() const {
  return std::exp2(-0.5 * step_);
}

void Pace::took(double ms) {
  begun_ = true;
  last_ms_ = ms;
  if (step_ == most_steps) lowest_ms_ = ms;
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
