// Needs as text and as JSON.
#pragma once

#include "needs/needs.h"

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <vector>

namespace gg::needs {

// Features that some draw uses, as "base color map" or "shading: metal", and how many draws do.
struct FeatureUse {
  std::string name;
  std::size_t draws = 0;
};
std::vector<FeatureUse> features_in_use(const std::vector<Draw>& draws);

std::string text_of(const Needs& needs); // several lines
nlohmann::json json_of(const Needs& needs);

} // namespace gg::needs
