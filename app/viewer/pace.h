// The resolution that keeps a picture in motion at a wanted rate.
#pragma once

namespace gg::viewer {

class Pace {
public:
  Pace() = default;
  explicit Pace(int step) : step_(step) {} // to begin with: roots of two below the full size

  // `others_ms`: what a frame takes besides the picture, which gets a third of the time at least.
  void want(double frames_per_second, double others_ms = 0.0);
  double wanted_ms() const { return wanted_ms_; } // of the picture
  // Before the first frame: what a picture took at full size.
  void begin(double full_ms);

  // The part of the full width and height to draw while something moves: 1, or less by steps of the root of two (so that targets
  // are rarely created again), not below an eighth.
  double scale() const;
  // What the last frame at scale() took. A step down at once where it was too slow, as many as its pixels say; a step up when
  // five in a row say that the larger picture would be in time.
  void took(double ms);
  // The last picture took longer than wanted, or nothing is known.
  bool is_late() const { return !begun_ || last_ms_ > wanted_ms_; }
  // The last frame at the lowest resolution took more than twice its time: there is no half of the wanted rate.
  bool is_out_of_reach() const { return lowest_ms_ > 2.0 * wanted_ms_; }

private:
  double wanted_ms_ = 1000.0 / 30.0;
  int step_ = 2; // a half to begin with: nothing is known
  bool begun_ = false;
  int in_time_ = 0;
  double last_ms_ = 0.0;   // of the last frame
  double lowest_ms_ = 0.0; // of the last frame at an eighth
};

} // namespace gg::viewer
