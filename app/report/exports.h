// The report for other programs.
#pragma once

#include "report/results.h"

#include <string>

namespace gg::report {

// Everything but the pictures.
nlohmann::json to_json(const Report& report);

// One line per scene, method and backend, under a line of names. Errors are over the objects.
std::string to_csv(const Report& report);

} // namespace gg::report
