// Features that a frame can be drawn without, to measure each.
#pragma once

#include "needs/features.h"

#include <set>
#include <string>
#include <vector>

namespace gg::needs {

// As `groundglass needs` calls them: "normal map", "dispersion", "neighbours", ...
const std::vector<std::string>& names_to_leave_out();
// Of names with a comma after each but the last; empty: none. Throws Error(usage) naming --without.
FeatureSet left_out(const std::string& names);
// Such a list taken apart, and the features of these names.
std::set<std::string> names_left_out(const std::string& names);
FeatureSet left_out(const std::set<std::string>& names);

} // namespace gg::needs
