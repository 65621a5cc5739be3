// The tables of a scene, as HTML.
#pragma once

#include "report/results.h"

#include <string>

namespace gg::report {

// Times and errors, one row per cell; the chosen one marked.
std::string results_table(const Section& section);
// relMSE of groups of objects, one column per method and backend, with the most samples; the least of each row in bold.
enum class Grouping { material, roughness };
std::string groups_table(const Section& section, Grouping grouping);
// Milliseconds per pass.
std::string passes_table(const Section& section);
// One row per scene: what is fastest, most accurate, and chosen.
std::string summary_table(const Report& report);

// "lobes2"; "lobes2, 4 samples on vulkan" where the section has several sample counts and backends.
std::string cell_name(const Section& section, const Cell& cell);
// What was chosen and why, in a sentence; empty if nothing was asked for.
std::string choice_text(const Section& section, const Limit& limit);
// What to take from the section, in a sentence: the choice, or the most accurate beside `standard`.
std::string verdict_text(const Section& section, const Limit& limit);

} // namespace gg::report
