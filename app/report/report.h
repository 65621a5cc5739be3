// groundglass report: scenes by methods by devices, measured and written out.
#pragma once

#include "report/results.h"
#include "report/subject.h"

namespace gg::report {

// What a run had to do; the rest was in the cache.
struct Work {
  std::size_t traced = 0, drawn = 0, timed = 0;
};

struct Outcome {
  Report report; // the scenes that are finished
  Work work;
  bool interrupted = false;
};

// Measures scene after scene, through a cache in plan.directory/cache, and after each writes
// report.html, report.json, report.csv and plots.svg again, so that an interrupt (Ctrl-C) loses what
// is half done at most. The directory is made. Throws Error.
Outcome run(const Plan& plan);

// One scene measured, without files other than the cache's. Throws Interrupted.
class Devices;
class Cache;
Section measure(const Subject& subject, const Plan& plan, const Cache& cache, Devices& devices,
                Work& work);

} // namespace gg::report
