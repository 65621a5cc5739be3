#include "needs/words.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>

namespace gg::needs {
namespace {

// A feature and what its values from 0 up are called; without such names only its presence counts.
struct FeatureName {
  Feature feature;
  const char* name;
  std::array<const char*, 16> values{};
};
constexpr FeatureName names[] = {
    {Feature::shading, "shading", {"unlit", "dielectric", "metal", "mixed", "conductor"}},
    {Feature::transmission, "transmission", {nullptr, "thin-walled", "solid"}},
    {Feature::distribution, "distribution", {"ggx", "beckmann", "phong"}},
    {Feature::alpha_mode, "alpha", {nullptr, "mask", "blend"}},
    {Feature::base_color_map, "base color map"},
    {Feature::metallic_roughness_map, "metallic-roughness map"},
    {Feature::normal_map, "normal map"},
    {Feature::occlusion_map, "occlusion map"},
    {Feature::emissive_map, "emissive map"},
    {Feature::specular_map, "specular map"},
    {Feature::specular_color_map, "specular color map"},
    {Feature::transmission_map, "transmission map"},
    {Feature::thickness_map, "thickness map"},
    {Feature::clearcoat, "clearcoat"},
    {Feature::clearcoat_map, "clearcoat map"},
    {Feature::clearcoat_roughness_map, "clearcoat roughness map"},
    {Feature::clearcoat_normal_map, "clearcoat normal map"},
    {Feature::anisotropy,
     "anisotropy",
     {nullptr, "of glass, by the samples of a pixel", "by two lobes", nullptr, "by four lobes",
      nullptr, "by six lobes"}},
    {Feature::anisotropy_map, "anisotropy map"},
    {Feature::iridescence, "iridescence"},
    {Feature::iridescence_map, "iridescence map"},
    {Feature::iridescence_thickness_map, "iridescence thickness map"},
    {Feature::diffuse_transmission, "diffuse transmission"},
    {Feature::diffuse_transmission_map, "diffuse transmission map"},
    {Feature::diffuse_transmission_color_map, "diffuse transmission color map"},
    {Feature::vertex_color, "vertex color"},
    {Feature::hollows, "hollows"},
    {Feature::alpha_given, "alpha given"},
    {Feature::correlated_smith, "correlated smith"},
    {Feature::multiple_scattering, "multiple scattering"},
    {Feature::schlick_dielectric, "tinted reflectance"},
    {Feature::environment, "environment"},
    {Feature::lights,
     "lights",
     {nullptr, "no shadow maps", "shadow maps", "shadow maps, tinted by glass"}},
    {Feature::dispersion, "dispersion"},
    {Feature::index_one, "IOR 1"},
    {Feature::attenuation, "absorption"},
    {Feature::seen_from_within, "seen from within"},
    {Feature::smooth, "smooth"},
    {Feature::holds_opaque, "opaque things inside"},
    {Feature::lobe_count,
     "reflection by",
     {nullptr, "one lobe", "two lobes", "three lobes", "four lobes"}},
    {Feature::interior_pairs, "interior", {nullptr, "one pair of faces", "two pairs of faces"}},
    {Feature::neighbours,
     "neighbours",
     {nullptr, nullptr, nullptr, nullptr, nullptr, "spheres of glass", "rectangles of glass",
      "spheres and rectangles of glass", nullptr, "spheres", "rectangles", "spheres and rectangles",
      nullptr, "spheres, glass among them", "rectangles, glass among them",
      "spheres and rectangles, glass among them"}},
    {Feature::interpolated_neighbours, "interpolated neighbours"},
};

std::string name_of(const FeatureName& feature, int value) {
  const char* named = static_cast<std::size_t>(value) < feature.values.size()
                          ? feature.values[static_cast<std::size_t>(value)]
                          : nullptr;
  return named ? std::string(feature.name) + ": " + named : feature.name;
}

std::string counted(std::size_t n, const char* thing) {
  return fmt::format("{} {}{}", n, thing, n == 1 ? "" : "s");
}

} // namespace

std::vector<FeatureUse> features_in_use(const std::vector<Draw>& draws) {
  std::vector<FeatureUse> uses;
  for (const FeatureName& feature : names)
    for (int value = 0; value < static_cast<int>(feature.values.size()); ++value) {
      // Without names of values every value but 0 is the same: present.
      const bool named = feature.values[1] != nullptr;
      if (named ? !feature.values[static_cast<std::size_t>(value)] : value != 1) continue;
      const auto count = std::ranges::count_if(draws, [&](const Draw& draw) {
        const int own = value_of(draw.key, feature.feature);
        return named ? own == value : own != 0;
      });
      if (count > 0)
        uses.push_back(
            {named ? name_of(feature, value) : feature.name, static_cast<std::size_t>(count)});
    }
  return uses;
}

std::string text_of(const Needs& needs) {
  const Draws& draws = needs.draws;
  std::string text =
      fmt::format("{}, {} triangles", counted(draws.all.size(), "draw"), needs.triangle_count());
  if (draws.outside) text += fmt::format("; {} outside the view are left out", draws.outside);
  if (draws.invisible)
    text += fmt::format("; {} that cannot be seen are left out", draws.invisible);
  text += "\n";
  if (!needs.layers.empty())
    text += counted(needs.layers.size(), "layer") + " of glass, far to near\n";

  text += "\nfeatures\n";
  for (const FeatureUse& use : features_in_use(draws.all))
    text += fmt::format("  {:<36}{}\n", use.name, counted(use.draws, "draw"));

  const Lookups& lookups = needs.lookups;
  text += fmt::format("\nlookups of scene-colour pyramid and environment, at most, per pixel\n"
                      "  reflected {}, refracted {}, internally reflected {}, residual {}\n",
                      lookups.reflected, lookups.refracted, lookups.internally_reflected,
                      lookups.residual);

  if (!needs.tables.empty()) text += "\ntables\n";
  for (const Table& table : needs.tables)
    text += fmt::format("  {:<44}{:>12}\n", table.file, table.bytes);
  return text;
}

nlohmann::json json_of(const Needs& needs) {
  using nlohmann::json;
  json features = json::object(), tables = json::array();
  for (const FeatureUse& use : features_in_use(needs.draws.all))
    features[use.name] = use.draws;
  for (const Table& table : needs.tables)
    tables.push_back({{"file", table.file}, {"lobes", table.lobes}, {"bytes", table.bytes}});
  return {{"width", needs.view.width},
          {"height", needs.view.height},
          {"samples", needs.view.samples},
          {"draws", needs.draws.all.size()},
          {"outside", needs.draws.outside},
          {"invisible", needs.draws.invisible},
          {"triangles", needs.triangle_count()},
          {"layers", needs.layers.size()},
          {"features", features},
          {"lookups",
           {{"reflected", needs.lookups.reflected},
            {"refracted", needs.lookups.refracted},
            {"internally_reflected", needs.lookups.internally_reflected},
            {"residual", needs.lookups.residual}}},
          {"tables", tables}};
}

} // namespace gg::needs
