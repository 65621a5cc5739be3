// A picture of known error: passes of samples over all pixels until enough is known.
#pragma once

#include "truth/film.h"
#include "truth/integrator.h"

#include <functional>

namespace gg::truth {

// The error itself is known no better than its samples: with fewer it may seem small because nothing
// bright has been met yet.
inline constexpr long least_samples = 16;

struct RenderDesc {
  std::uint64_t seed = 0;
  // Stop at this many samples per pixel, those already on the film included,
  long samples = 64;
  // or sooner, when Film::relative_error() has come down to this. 0: samples alone decide.
  double error = 0.0;
  int threads = 0; // 0: as many as the machine has
};

struct Watch {
  // Told about once a second what there is, and its relative error.
  std::function<void(const Film& film, double error)> report = [](const Film&, double) {};
  // Asked often, by any thread: work of about a second that it ends is dropped, what was there before is kept.
  std::function<bool()> stop = [] { return false; };
};

// Adds samples to the film. Sample k of a pixel depends on the seed, the pixel and k alone, so the
// result is the same for any number of threads and any way of dividing the work. Returns false if
// it was stopped before its goal.
bool render(const Integrator& integrator, const Camera& camera, const RenderDesc& desc, Film& film,
            const Watch& watch = {});

} // namespace gg::truth
