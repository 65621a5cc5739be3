// Error against time, as SVG.
#pragma once

#include "report/results.h"

#include <string>
#include <vector>

namespace gg::report {

// Both axes logarithmic; a point per cell with the quartiles of its time, larger for more samples, a
// line through those of one method on one backend, the Pareto front as steps,
// the part of the error that is the truth's noise, and the limit asked for. An element <svg> that
// scales with its width and refers to nothing outside.
std::string plot(const Section& section, const Limit& limit, Measure measure);

// All scenes' plots side by side, by both measures, trimmed first, as a file of its own.
std::string plots(const Report& report);

// Round numbers from `low` to `high` (both positive), eight at the most: 1, 1.5, 2, 3, 4, 5, 6, 8 times
// powers of ten, or 1, 2, 5, or the powers, or every second of them and so on.
std::vector<double> log_ticks(double low, double high);

} // namespace gg::report
