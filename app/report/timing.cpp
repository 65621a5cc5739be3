#include "report/timing.h"

#include <chrono>
#include <map>

namespace gg::report {
namespace {

using Clock = std::chrono::steady_clock;

double ms_since(Clock::time_point start) {
  return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

struct Samples {
  std::vector<double> frames;
  std::map<std::string, std::vector<double>> passes;
};

// The passes' own timers are read in a frame of their own: reading them waits for the device.
void measure(const Timed& timed, Samples& samples) {
  timed.device->finish();
  const auto start = Clock::now();
  timed.renderer->draw();
  timed.device->finish();
  samples.frames.push_back(ms_since(start));
  std::map<std::string, double> times;
  timed.renderer->draw(&times);
  for (const auto& [label, ms] : times)
    samples.passes[label].push_back(ms);
}

Timing timing_of(const Timed& timed, Samples samples) {
  Timing timing{.frame = spread_of(std::move(samples.frames))};
  // A label that stands for several passes is one sum.
  for (const std::string& label : timed.renderer->pass_labels())
    if (const auto found = samples.passes.extract(label))
      timing.passes.emplace_back(label, spread_of(found.mapped()));
  return timing;
}

} // namespace

std::vector<Timing> time_in_turn(const std::vector<Timed>& timed, int frames,
                                 const std::function<void(int)>& progress) {
  std::vector<Samples> samples(timed.size());
  const auto start = Clock::now();
  for (int round = -warm_up_rounds; round < frames; ++round) {
    if (round >= least_rounds && ms_since(start) > patience_ms) break;
    for (std::size_t k = 0; k < timed.size(); ++k) {
      const std::size_t i = (k + static_cast<std::size_t>(round + warm_up_rounds)) % timed.size();
      Samples warm_up;
      measure(timed[i], round < 0 ? warm_up : samples[i]);
    }
    if (round >= 0) progress(round + 1);
  }
  std::vector<Timing> timings;
  for (std::size_t i = 0; i < timed.size(); ++i)
    timings.push_back(timing_of(timed[i], std::move(samples[i])));
  return timings;
}

} // namespace gg::report
