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
  std::array<const char*, 5> values{};
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
    {Feature::vertex_color, "vertex color"},
    {Feature::alpha_given, "alpha given"},
    {Feature::correlated_smith, "correlated smith"},
    {Feature::multiple_scattering, "multiple scattering"},
    {Feature::schlick_dielectric, "tinted reflectance"},
    {Feature::environment, "environment"},
    {Feature::lights, "lights"},
    {Feature::dispersion, "dispersion"},
    {Feature::index_one, "index 1"},
    {Feature::attenuation, "absorption"},
    {Feature::seen_from_within, "seen from within"},
    {Feature::smooth, "smooth"},
    {Feature::holds_opaque, "opaque things inside"},
    {Feature::lobe_taps,
     "reflection by",
     {nullptr, "one tap", "two taps", "three taps", "four taps"}},
    {Feature::interior_pairs, "interior", {nullptr, "one pair of faces", "two pairs of faces"}},
};

std::string name_of(const FeatureName& feature, int value) {
  const char* named = static_cast<std::size_t>(value) < feature.values.size()
                          ? feature.values[static_cast<std::size_t>(value)]
                          : nullptr;
  return named ? std::string(feature.name) + ": " + named : feature.name;
}

const char* word(Texel texel) {
  switch (texel) {
  case Texel::rgba32f:
    return "rgba32f";
  case Texel::r32f:
    return "r32f";
  case Texel::rgba32ui:
    return "rgba32ui";
  case Texel::depth32f:
    return "depth32f";
  }
  return "";
}

std::string joined(const std::vector<std::string>& words) {
  return fmt::format("{}", fmt::join(words, ", "));
}

std::string counted(std::size_t n, const char* thing) {
  return fmt::format("{} {}{}", n, thing, n == 1 ? "" : "s");
}

std::string size_of(const Target& t) {
  std::string text = fmt::format("{}x{}", t.width, t.height);
  if (t.layers > 1) text += fmt::format(" x {} layers", t.layers);
  if (t.levels > 1) text += fmt::format(", {} levels", t.levels);
  return text;
}

// The levels of a pyramid follow each other and are one line.
std::string passes_text(const std::vector<Pass>& passes) {
  std::size_t wide = 0; // the column of what is read
  for (const Pass& pass : passes)
    wide = std::max(wide, joined(pass.reads).size() + 2);
  const auto row = [wide](const std::string& label, std::size_t draws, const std::string& reads,
                          const std::string& writes) {
    return fmt::format("{:<14}{:>6}  {:<{}}{}\n", label, draws ? std::to_string(draws) : "", reads,
                       wide, writes);
  };
  std::string text =
      fmt::format("{:<14}{:>6}  {:<{}}{}\n", "pass", "draws", "reads", wide, "writes");
  for (std::size_t i = 0; i < passes.size(); ++i) {
    const Pass& pass = passes[i];
    if (pass.kind == PassKind::pyramid) {
      std::size_t last = i;
      while (last + 1 < passes.size() && passes[last + 1].kind == PassKind::pyramid)
        ++last;
      text += row(fmt::format("pyramid x {}", last - i + 1), 0, "each the level before",
                  fmt::format("screen pyramid {} to {}", pass.part, passes[last].part));
      i = last;
      continue;
    }
    text += row(pass.label, pass.draws, joined(pass.reads), joined(pass.writes));
  }
  return text;
}

} // namespace

std::vector<FeatureUse> features_in_use(const std::vector<Draw>& draws) {
  std::vector<FeatureUse> uses;
  for (const FeatureName& feature : names)
    for (int value = 0; value < 5; ++value) {
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
  text += "\n\n" + passes_text(needs.passes);
  if (!needs.layers.empty())
    text += counted(needs.layers.size(), "layer") + " of glass, far to near\n";

  text += "\nfeatures\n";
  for (const FeatureUse& use : features_in_use(draws.all))
    text += fmt::format("  {:<36}{}\n", use.name, counted(use.draws, "draw"));

  const Lookups& lookups = needs.lookups;
  text += fmt::format("\nlookups of the blurred surroundings, at most, per pixel\n"
                      "  reflected {}, refracted {}, bounced inside {}, left over {}\n",
                      lookups.reflected, lookups.refracted, lookups.bounced, lookups.left_over);

  if (!needs.tables.empty()) text += "\ntables\n";
  for (const Table& table : needs.tables)
    text += fmt::format("  {:<44}{:>12}\n", table.file, table.bytes);
  text += "\ntargets\n";
  for (const Target& target : needs.targets)
    text += fmt::format("  {:<16}{:<28}{:>12}\n", target.name,
                        size_of(target) + " " + word(target.texel), bytes_of(target));
  text += "\nbytes on the device\n";
  for (const Share& share : needs.memory)
    if (share.bytes > 0) text += fmt::format("  {:<44}{:>12}\n", share.of, share.bytes);
  text += fmt::format("  {:<44}{:>12}\n", "together", needs.bytes());
  return text;
}

nlohmann::json json_of(const Needs& needs) {
  using nlohmann::json;
  json passes = json::array(), features = json::object(), tables = json::array(),
       targets = json::array(), memory = json::object();
  for (const Pass& pass : needs.passes)
    passes.push_back({{"label", pass.label},
                      {"draws", pass.draws},
                      {"reads", pass.reads},
                      {"writes", pass.writes}});
  for (const FeatureUse& use : features_in_use(needs.draws.all))
    features[use.name] = use.draws;
  for (const Table& table : needs.tables)
    tables.push_back({{"file", table.file}, {"taps", table.taps}, {"bytes", table.bytes}});
  for (const Target& target : needs.targets)
    targets.push_back({{"name", target.name},
                       {"texel", word(target.texel)},
                       {"width", target.width},
                       {"height", target.height},
                       {"layers", target.layers},
                       {"levels", target.levels},
                       {"bytes", bytes_of(target)}});
  for (const Share& share : needs.memory)
    memory[share.of] = share.bytes;
  return {{"width", needs.view.width},
          {"height", needs.view.height},
          {"samples", needs.view.samples},
          {"draws", needs.draws.all.size()},
          {"outside", needs.draws.outside},
          {"invisible", needs.draws.invisible},
          {"triangles", needs.triangle_count()},
          {"layers", needs.layers.size()},
          {"passes", passes},
          {"features", features},
          {"lookups",
           {{"reflected", needs.lookups.reflected},
            {"refracted", needs.lookups.refracted},
            {"bounced", needs.lookups.bounced},
            {"left_over", needs.lookups.left_over}}},
          {"tables", tables},
          {"targets", targets},
          {"memory", memory},
          {"bytes", needs.bytes()}};
}

} // namespace gg::needs
