#include "scene/apply.h"

#include "core/suggest.h"
#include "scene/brushing.h"
#include "scene/presets.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cfloat>
#include <charconv>
#include <cmath>
#include <optional>
#include <sstream>

namespace gg::scene {
namespace {

class Reader {
public:
  Reader(const Setting& setting) : setting_(setting) {}

  [[noreturn]] void fail(const std::string& what, const std::string& remedy) const {
    throw Error(setting_.code, setting_.where, what, remedy);
  }

  float number(const std::string& key, const std::string& text, float low, float high) const {
    const auto value = parse(text);
    if (!value || !(*value >= low && *value <= high))
      fail(key + " is '" + text.substr(0, 40) + "'",
           std::isfinite(high) ? fmt::format("It is a number from {} to {}.", low, high)
                               : fmt::format("It is a number of at least {}.", low));
    return *value;
  }

  glm::vec3 color(const std::string& key, const std::string& text) const {
    if (const auto rgb = hexadecimal(text)) return *rgb;
    glm::vec3 rgb(0.0f);
    std::istringstream parts(text);
    std::string part;
    int count = 0;
    for (; std::getline(parts, part, '/') && count < 3; ++count)
      rgb[count] = number(key, part, 0.0f, 1.0f);
    if (count != 3 || text.ends_with('/') || std::count(text.begin(), text.end(), '/') != 2)
      fail(key + " is '" + text.substr(0, 40) + "'",
           "It is three linear numbers from 0 to 1, as 0.8/0.2/0.1, or #rrggbb.");
    return rgb;
  }

  const Preset& preset(const std::string& name) const {
    if (const Preset* found = find_preset(name)) return *found;
    std::vector<std::string> names;
    for (const Preset& one : presets())
      names.emplace_back(one.name);
    fail("there is no preset '" + name.substr(0, 40) + "'",
         did_you_mean(name, names) + "Metals: " + preset_names(PresetKind::conductor)
             + ". Clear solids: " + preset_names(PresetKind::dielectric)
             + ". Finishes: " + preset_names(PresetKind::finish) + ".");
  }

private:
  static std::optional<float> parse(const std::string& text) {
    float value = 0.0f;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value))
      return std::nullopt;
    return value;
  }

  // #rrggbb is display-encoded (IEC 61966-2-1).
  static std::optional<glm::vec3> hexadecimal(const std::string& text) {
    if (text.size() != 7 || text[0] != '#') return std::nullopt;
    glm::vec3 rgb(0.0f);
    for (int i = 0; i < 3; ++i) {
      int value = 0;
      const char* at = text.data() + 1 + 2 * i;
      if (std::from_chars(at, at + 2, value, 16).ptr != at + 2) return std::nullopt;
      const float encoded = static_cast<float>(value) / 255.0f;
      rgb[i] = encoded <= 0.04045f ? encoded / 12.92f : std::pow((encoded + 0.055f) / 1.055f, 2.4f);
    }
    return rgb;
  }

  const Setting& setting_;
};

// What both metals and clear solids start from: nothing of the old surface but its shape.
Material bare(const Material& old) {
  Material m;
  m.name = old.name;
  m.normal_map = old.normal_map;
  m.occlusion_map = old.occlusion_map;
  m.double_sided = old.double_sided;
  return m;
}

void apply_preset(const Preset& preset, float extent, Material& m) {
  switch (preset.kind) {
  case PresetKind::conductor:
    m = bare(m);
    m.conductor = preset.conductor;
    m.metallic = 1.0f;
    m.base_color = glm::vec4(normal_reflectance(preset.conductor), 1.0f);
    break;
  case PresetKind::dielectric:
    m = bare(m);
    m.metallic = 0.0f;
    m.ior = preset.ior;
    m.dispersion = preset.abbe > 0.0f ? 20.0f / preset.abbe : 0.0f;
    m.transmission = 1.0f;
    m.thickness = extent;
    m.attenuation_distance = preset.attenuation_distance;
    m.attenuation_color = preset.attenuation_color;
    break;
  case PresetKind::finish:
    break;
  }
  m.preset = preset.name;
}

void set_alpha(Material& m, float alpha) {
  m.exact_alpha = alpha;
  m.roughness = std::sqrt(alpha);
}

void apply_option(const Reader& read, const std::string& key, const std::string& value,
                  Material& m) {
  constexpr float unlimited = INFINITY;
  // The tables' axis (refraction/interface_table.glsl). Below 1 it is a bubble in what is denser.
  constexpr float least_ior = 0.25f, greatest_ior = 4.0f;
  constexpr std::array not_of_metals = {
      "color",     "ior", "thickness", "attenuation_distance", "back_alpha", "attenuation_color",
      "dispersion"};
  if (m.conductor
      && std::find(not_of_metals.begin(), not_of_metals.end(), key) != not_of_metals.end())
    read.fail(key + " does not apply to a metal",
              "Its colour follows from its complex index, and no light enters it.");
  if (key == "alpha")
    set_alpha(m, read.number(key, value, 0.0f, 1.0f));
  else if (key == "roughness") {
    const float roughness = read.number(key, value, 0.0f, 1.0f);
    set_alpha(m, roughness * roughness);
  } else if (key == "finish") {
    const Preset& finish = read.preset(value);
    if (finish.kind != PresetKind::finish)
      read.fail("'" + value + "' is not a finish",
                "Finishes: " + preset_names(PresetKind::finish) + ".");
    set_alpha(m, finish.alpha);
  } else if (key == "back_alpha")
    m.back_alpha = read.number(key, value, 0.0f, 1.0f);
  else if (key == "distribution") {
    if (value == "ggx")
      m.distribution = Distribution::ggx;
    else if (value == "beckmann")
      m.distribution = Distribution::beckmann;
    else if (value == "phong")
      m.distribution = Distribution::phong;
    else
      read.fail("there is no distribution '" + value.substr(0, 40) + "'",
                "Distributions: ggx, beckmann, phong.");
  } else if (key == "color")
    m.base_color = glm::vec4(read.color(key, value), m.base_color.w);
  else if (key == "ior")
    m.ior = read.number(key, value, least_ior, greatest_ior);
  else if (key == "thickness")
    m.thickness = read.number(key, value, 0.0f, unlimited);
  else if (key == "attenuation_distance")
    m.attenuation_distance = read.number(key, value, FLT_MIN, unlimited);
  else if (key == "attenuation_color")
    m.attenuation_color = read.color(key, value);
  else if (key == "dispersion")
    m.dispersion = read.number(key, value, 0.0f, unlimited);
  else if (key == "anisotropy")
    m.anisotropy_strength = read.number(key, value, 0.0f, 1.0f);
  else if (key == "anisotropy_rotation")
    m.anisotropy_rotation = glm::radians(read.number(key, value, -360.0f, 360.0f));
  else if (key == "clearcoat")
    m.clearcoat = read.number(key, value, 0.0f, 1.0f);
  else if (key == "clearcoat_roughness")
    m.clearcoat_roughness = read.number(key, value, 0.0f, 1.0f);
  else if (key == "iridescence")
    m.iridescence = read.number(key, value, 0.0f, 1.0f);
  else if (key == "iridescence_ior")
    m.iridescence_ior = read.number(key, value, 1.0f, greatest_ior);
  else if (key == "iridescence_thickness")
    m.iridescence_thickness = glm::vec2(read.number(key, value, 0.0f, unlimited));
  else {
    const std::vector<std::string> keys{"alpha",
                                        "roughness",
                                        "finish",
                                        "back_alpha",
                                        "distribution",
                                        "color",
                                        "ior",
                                        "thickness",
                                        "attenuation_distance",
                                        "attenuation_color",
                                        "dispersion",
                                        "anisotropy",
                                        "anisotropy_rotation",
                                        "clearcoat",
                                        "clearcoat_roughness",
                                        "iridescence",
                                        "iridescence_ior",
                                        "iridescence_thickness"};
    read.fail("there is no setting '" + key.substr(0, 40) + "'",
              did_you_mean(key, keys) + fmt::format("Settings: {}.", fmt::join(keys, ", ")));
  }
}

std::string material_names(const Scene& scene, const std::string& wanted) {
  std::vector<std::string> names;
  for (const Material& material : scene.materials)
    names.push_back(material.name);
  constexpr std::size_t most = 24;
  std::string text;
  for (std::size_t i = 0; i < std::min(most, scene.materials.size()); ++i)
    text += fmt::format("{}{}", i ? ", " : "",
                        scene.materials[i].name.empty() ? fmt::format("#{}", i)
                                                        : scene.materials[i].name);
  if (scene.materials.size() > most)
    text += fmt::format(" and {} more", scene.materials.size() - most);
  return text.empty() ? "The scene has no materials."
                      : did_you_mean(wanted, names) + "The scene has: " + text + "; or '*'.";
}

// The materials that a name stands for.
std::vector<Index> matches(const Scene& scene, const std::string& name) {
  std::vector<Index> result;
  for (Index i = 0; i < static_cast<Index>(scene.materials.size()); ++i)
    if (name == "*" || name == scene.materials[static_cast<std::size_t>(i)].name
        || name == fmt::format("#{}", i))
      result.push_back(i);
  return result;
}

} // namespace

float extent_of(const Scene& scene, Index material) {
  float least = INFINITY;
  for (const Mesh& mesh : scene.meshes)
    for (const Primitive& p : mesh.primitives)
      if (p.material == material && !p.bounds.empty()) {
        const glm::vec3 size = p.bounds.high - p.bounds.low;
        least = std::min(least, std::min(size.x, std::min(size.y, size.z)));
      }
  return std::isfinite(least) ? least : 0.0f;
}

void apply_setting(const Setting& setting, float extent, Material& material) {
  const Reader read(setting);
  Material changed = material;
  if (!setting.preset.empty()) {
    const Preset& preset = read.preset(setting.preset);
    apply_preset(preset, extent, changed);
    set_alpha(changed, preset.alpha);
  }
  for (const auto& [key, value] : setting.options)
    apply_option(read, key, value, changed);
  material = std::move(changed);
}

void apply_material(Scene& scene, const std::string& spec) {
  const std::string where = "--material '" + spec + "'";
  // Names may contain '=': the first split that names a material counts.
  std::vector<Index> targets;
  std::size_t split = spec.find('=');
  if (split == std::string::npos)
    throw Error(ExitCode::usage, where, "has no '='",
                "Write NAME=PRESET, as in '*=gold,alpha=0.2'.");
  for (std::size_t at = split; at != std::string::npos && targets.empty();
       at = spec.find('=', at + 1))
    if (targets = matches(scene, spec.substr(0, at)); !targets.empty()) split = at;
  if (targets.empty())
    throw Error(ExitCode::usage, where, "there is no material '" + spec.substr(0, split) + "'",
                material_names(scene, spec.substr(0, split)));

  Setting setting;
  setting.where = where;
  std::istringstream parts(spec.substr(split + 1));
  std::getline(parts, setting.preset, ',');
  for (std::string part; std::getline(parts, part, ',');) {
    const std::size_t equals = part.find('=');
    setting.options.emplace_back(part.substr(0, equals),
                                 equals == std::string::npos ? "" : part.substr(equals + 1));
  }
  if (setting.preset.empty() && setting.options.empty()) Reader(setting).preset("");
  std::vector<Material> changed;
  for (const Index i : targets) {
    changed.push_back(scene.materials[static_cast<std::size_t>(i)]);
    apply_setting(setting, extent_of(scene, i), changed.back());
  }
  for (std::size_t i = 0; i < targets.size(); ++i)
    scene.materials[static_cast<std::size_t>(targets[i])] = std::move(changed[i]);
  complete_brushing(scene);
}

} // namespace gg::scene
