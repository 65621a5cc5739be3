// The report as one HTML file that opens from disk: pictures, plots, style and script inside.
#pragma once

#include "report/results.h"

#include <string>

namespace gg::report {

// The style and the script are assets/report/; throws Error(input) if they are missing.
std::string page(const Report& report);

} // namespace gg::report
