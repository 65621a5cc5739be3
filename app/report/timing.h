// How long frames take, measured so that methods can be compared.
#pragma once

#include "frame/renderer.h"
#include "report/results.h"

#include <functional>
#include <vector>

namespace gg::report {

// A picture: what draws it, and by how many samples per pixel. Several may share a renderer.
struct Timed {
  gpu::Device* device = nullptr;
  frame::Renderer* renderer = nullptr;
  int samples = 1;
};

// Times `pictures` pictures of each, all samples: in rounds of one each, in an order that turns from
// round to round, so that whatever else the machine does hurts all alike. Slow scenes get fewer
// rounds (`least_rounds` at the least) once `patience_ms` is used up. Passes are timed in
// `pass_rounds` rounds, as reading their timers waits for the device. `progress` is told the rounds
// done after each; it throws to stop.
std::vector<Timing> time_in_turn(const std::vector<Timed>& timed, int pictures,
                                 const std::function<void(int)>& progress);

inline constexpr int warm_up_frames = 3; // of one sample, until caches and clocks have settled
inline constexpr int pass_rounds = 3;
// A median of five is still one of the three middle values when one in five is disturbed.
inline constexpr int least_rounds = 5;
inline constexpr double patience_ms = 90'000.0;

} // namespace gg::report
