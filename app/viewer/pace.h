// The resolution that keeps a picture in motion at a wanted rate.
#pragma once

namespace gg::viewer {

class Pace {
public:
  // `others_ms`: what a frame takes besides the picture, which gets a third of the time at least.
  void want(double frames_per_second, double others_ms = 0.0);
  // Before the first frame: what a picture took at full size.
  void begin(double full_ms);

  // The part of the full width and height to draw while something moves: 1, or less by steps of the root of two (so that targets
  // are rarely created again), not below an eighth.
  double scale() const;
  // What the last frame at scale() took. A step down at once where it was too slow, as many as its pixels say; a step up when
  // five in a row say that the larger picture would be in time.
  void took(double ms);

private:
  double wanted_ms_ = 1000.0 / 30.0;
  int step_ = 2; // a half to begin with: nothing is known
  bool begun_ = false;
  int in_time_ = 0;
};

} // namespace gg::viewer
