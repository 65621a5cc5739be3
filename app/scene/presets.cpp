// The numbers behind the names.
//
// Metals. One wavelength stands for each channel of linear Rec.709: 659.5 nm (red), 548.6 nm
// (green) and 450.9 nm (blue), rows of Johnson and Christy's tables (1.88, 2.26 and 2.75 eV); the
// others are interpolated linearly to them. Three wavelengths give slightly paler colours than the
// whole spectrum would: gold's blue is 0.41 here and 0.3 to 0.34 as a projected spectrum, whose red
// then exceeds 1, which no index can reflect.
//
// Dielectrics. Index n_d at 587.6 nm and Abbe number V_d = (n_d - 1) / (n_F - n_C), textbook or
// catalogue values.
#include "scene/presets.h"

#include <array>

namespace gg::scene {
namespace {

constexpr const char* noble = "Johnson and Christy, Phys. Rev. B 6, 4370 (1972)";
constexpr const char* transition = "Johnson and Christy, Phys. Rev. B 9, 5056 (1974)";
constexpr const char* rakic = "Rakic et al., Appl. Opt. 37, 5271 (1998), Lorentz-Drude model";
constexpr const char* querry = "Querry, CRDC-CR-85034 (1985), 70 % Cu, 30 % Zn";
constexpr const char* schott = "Schott optical glass data sheet";

constexpr float metal_alpha = 0.1f; // cast or machined and rubbed: visibly not a mirror

constexpr Preset metal(std::string_view name, std::string_view source, glm::vec3 n, glm::vec3 k) {
  return {.name = name,
          .kind = PresetKind::conductor,
          .source = source,
          .alpha = metal_alpha,
          .conductor = {n, k}};
}

constexpr Preset clear(std::string_view name, std::string_view source, float ior, float abbe) {
  return {.name = name,
          .kind = PresetKind::dielectric,
          .source = source,
          .alpha = 0.0f,
          .ior = ior,
          .abbe = abbe};
}

constexpr Preset finish(std::string_view name, float alpha) {
  return {
      .name = name, .kind = PresetKind::finish, .source = "a width chosen by eye", .alpha = alpha};
}

// Pure water absorbs 0.340, 0.0565 and 0.00922 per metre at 650, 550 and 450 nm; the colour is what
// is left of white after one metre: exp(-a).
constexpr Preset water() {
  Preset p =
      clear("water", "n, V: Daimon and Masumura (2007), 20 C; absorption: Pope and Fry (1997)",
            1.333f, 55.8f);
  p.attenuation_distance = 1.0f;
  p.attenuation_color = {0.7118f, 0.9451f, 0.9908f};
  return p;
}

constexpr std::array table{
    metal("aluminium", rakic, {1.467f, 0.960f, 0.593f}, {7.560f, 6.443f, 5.322f}),
    metal("brass", querry, {0.445f, 0.530f, 1.085f}, {3.774f, 2.751f, 1.834f}),
    metal("chromium", transition, {3.09f, 3.18f, 2.33f}, {3.34f, 3.33f, 3.14f}),
    metal("copper", noble, {0.22f, 1.02f, 1.24f}, {3.747f, 2.577f, 2.397f}),
    metal("gold", noble, {0.14f, 0.43f, 1.38f}, {3.697f, 2.455f, 1.914f}),
    metal("iron", transition, {2.92f, 2.95f, 2.59f}, {3.10f, 2.93f, 2.77f}),
    metal("nickel", transition, {1.99f, 1.92f, 1.73f}, {4.26f, 3.61f, 2.95f}),
    metal("platinum", rakic, {2.399f, 2.087f, 1.853f}, {4.303f, 3.696f, 3.145f}),
    metal("silver", noble, {0.05f, 0.06f, 0.04f}, {4.483f, 3.586f, 2.657f}),
    metal("titanium", transition, {2.76f, 2.54f, 2.27f}, {3.84f, 3.43f, 3.04f}),
    metal("tungsten", rakic, {3.735f, 3.453f, 3.370f}, {2.879f, 2.753f, 2.527f}),

    clear("acrylic", "PMMA; Sultanova et al. (2009)", 1.491f, 57.4f),
    clear("bk7", schott, 1.5168f, 64.17f),
    clear("diamond", "Peter (1923)", 2.417f, 55.3f),
    clear("flint", "SF11; Schott optical glass data sheet", 1.7847f, 25.68f),
    clear("fused-silica", "Malitson (1965)", 1.4585f, 67.8f),
    clear("glass", "the usual round number; no dispersion", 1.5f, 0.0f),
    clear("ice", "Warren (1984); no dispersion", 1.31f, 0.0f),
    clear("polycarbonate", "Sultanova et al. (2009)", 1.585f, 29.9f),
    clear("sapphire", "Malitson (1962), ordinary ray", 1.768f, 72.2f),
    water(),

    finish("brushed", 0.25f), // without a direction: the mean of its two widths
    finish("matte", 0.5f),
    finish("mirror", 0.0f),
    finish("polished", 0.03f),
    finish("satin", 0.15f),
};

} // namespace

std::span<const Preset> presets() {
  return table;
}

const Preset* find_preset(std::string_view name) {
  for (const Preset& preset : table)
    if (preset.name == name) return &preset;
  return nullptr;
}

glm::vec3 normal_reflectance(const Conductor& c) {
  const glm::vec3 k2 = c.k * c.k, below = c.n - 1.0f, above = c.n + 1.0f;
  return (below * below + k2) / (above * above + k2);
}

std::string preset_names(PresetKind kind) {
  std::string text;
  for (const Preset& preset : table)
    if (preset.kind == kind) {
      if (!text.empty()) text += ", ";
      text += preset.name;
    }
  return text;
}

} // namespace gg::scene
