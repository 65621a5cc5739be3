// The truth of a scene: traced once, kept, and added to when more is asked for.
#pragma once

#include "report/cache.h"
#include "report/subject.h"

#include <functional>

namespace gg::report {

struct TruthRecord {
  std::filesystem::path file; // .exr, as `groundglass truth` writes it
  std::string key;            // of what it shows and of how many samples it has
  long samples = 0;
  double error = 0.0;   // relative
  double seconds = 0.0; // spent on it altogether
  bool traced = false;  // in this run
};

// The truth in the cache if it is good enough, else it is traced on from there. Interrupted, it
// stores what it has and throws Interrupted. `loaded` is asked for the scene only if it is traced.
TruthRecord truth_of(const Subject& subject, const Plan& plan, const Cache& cache,
                     const std::function<const Loaded&()>& loaded);

// Ctrl-C, once what can be kept is stored.
struct Interrupted {};

} // namespace gg::report
