#include "report/timing.h"

#include "core/clock.h"

#include <map>

namespace gg::report {
namespace {

struct Samples {
  std::vector<double> pictures;
  std::map<std::string, std::vector<double>> passes;
};

// Sets the renderer to the picture, with a frame after it: what is made for it is not timed.
void prepare(const Timed& timed) {
  frame::FrameDesc desc = timed.renderer->desc();
  if (desc.samples == timed.samples) return;
  desc.samples = timed.samples;
  timed.renderer->set(desc);
  timed.renderer->draw_sample(0);
}

void measure(const Timed& timed, bool passes, Samples& samples) {
  prepare(timed);
  timed.device->finish();
  const auto start = Clock::now();
  timed.renderer->draw();
  timed.device->finish();
  samples.pictures.push_back(ms_since(start));
  if (!passes) return;
  std::map<std::string, double> times;
  timed.renderer->draw(&times);
  for (const auto& [label, ms] : times)
    samples.passes[label].push_back(ms);
}

Timing timing_of(const Timed& timed, Samples samples) {
  Timing timing{.picture = spread_of(std::move(samples.pictures))};
  // A label that stands for several passes is one sum.
  for (const std::string& label : timed.renderer->pass_labels())
    if (const auto found = samples.passes.extract(label))
      timing.passes.emplace_back(label, spread_of(found.mapped()));
  return timing;
}

} // namespace

std::vector<Timing> time_in_turn(const std::vector<Timed>& timed, int pictures,
                                 const std::function<void(int)>& progress) {
  std::vector<Samples> samples(timed.size());
  for (const Timed& one : timed)
    for (int i = 0; i < warm_up_frames; ++i) {
      prepare(one);
      one.renderer->draw_sample(0);
      one.device->finish();
    }
  const auto start = Clock::now();
  for (int round = 0; round < pictures; ++round) {
    if (round >= least_rounds && ms_since(start) > patience_ms) break;
    for (std::size_t k = 0; k < timed.size(); ++k) {
      const std::size_t i = (k + static_cast<std::size_t>(round)) % timed.size();
      measure(timed[i], round < pass_rounds, samples[i]);
    }
    progress(round + 1);
  }
  std::vector<Timing> timings;
  for (std::size_t i = 0; i < timed.size(); ++i)
    timings.push_back(timing_of(timed[i], std::move(samples[i])));
  return timings;
}

} // namespace gg::report
