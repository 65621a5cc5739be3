#include "needs/left_out.h"

#include "core/error.h"
#include "core/suggest.h"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>

namespace gg::needs {
namespace {

// Those that stand for light or for what a material is are changed by options of their own.
struct Entry {
  const char* name;
  Feature feature;
};
constexpr Entry entries[] = {
    {"base color map", Feature::base_color_map},
    {"metallic-roughness map", Feature::metallic_roughness_map},
    {"normal map", Feature::normal_map},
    {"occlusion map", Feature::occlusion_map},
    {"emissive map", Feature::emissive_map},
    {"specular map", Feature::specular_map},
    {"specular color map", Feature::specular_color_map},
    {"transmission map", Feature::transmission_map},
    {"thickness map", Feature::thickness_map},
    {"clearcoat", Feature::clearcoat},
    {"clearcoat map", Feature::clearcoat_map},
    {"clearcoat roughness map", Feature::clearcoat_roughness_map},
    {"clearcoat normal map", Feature::clearcoat_normal_map},
    {"anisotropy", Feature::anisotropy},
    {"anisotropy map", Feature::anisotropy_map},
    {"iridescence", Feature::iridescence},
    {"iridescence map", Feature::iridescence_map},
    {"iridescence thickness map", Feature::iridescence_thickness_map},
    {"vertex color", Feature::vertex_color},
    {"lights", Feature::lights},
    {"dispersion", Feature::dispersion},
    {"absorption", Feature::attenuation},
    {"neighbours", Feature::neighbours},
    {"interpolated neighbours", Feature::interpolated_neighbours},
    {"hollows", Feature::hollows},
};

} // namespace

const std::vector<std::string>& names_to_leave_out() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all;
    for (const Entry& entry : entries)
      all.emplace_back(entry.name);
    return all;
  }();
  return names;
}

std::set<std::string> names_left_out(const std::string& names) {
  std::set<std::string> all;
  std::istringstream in(names);
  for (std::string name; std::getline(in, name, ',');)
    all.insert(name);
  return all;
}

FeatureSet left_out(const std::string& names) {
  return left_out(names_left_out(names));
}

FeatureSet left_out(const std::set<std::string>& names) {
  FeatureSet set;
  for (const std::string& name : names) {
    const auto* const found = std::ranges::find(entries, name, &Entry::name);
    if (found == std::end(entries))
      throw Error(
          ExitCode::usage, "--without", "'" + name + "' is not known",
          did_you_mean(name, names_to_leave_out())
              + fmt::format("What can be left out: {}.", fmt::join(names_to_leave_out(), ", ")));
    set.set(static_cast<std::size_t>(found->feature));
  }
  return set;
}

} // namespace gg::needs
