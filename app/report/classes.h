// What kind of thing an object is: by its materials, for errors told apart by kind and roughness.
#pragma once

#include "scene/scene.h"

#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace gg::report {

struct ObjectKind {
  std::string material; // "metal", "dielectric", "glass", "thin glass", "blended", "unlit", "mixed"
  std::string roughness; // a band of alpha, "textured" or "several"; empty for what is unlit
  bool shaded = true;    // false: its radiance is its colour, the same in every method
};

// Of a material. Glass is what transmits more than half of what enters it.
std::string material_class(const scene::Material& material);
// Of alpha: "0", "to .1", "to .3", "over .3"; "textured" where a map varies it.
std::string roughness_band(const scene::Material& material);
// The bands and "several", in the order in which they are shown.
inline constexpr std::array<std::string_view, 6> roughness_bands = {
    "0", "to .1", "to .3", "over .3", "textured", "several"};

// By instance; the truth's object id is 1 more. An object of several materials is "mixed" unless
// they are of one class, its roughness "several" unless they are of one band.
std::vector<ObjectKind> kinds_of(const scene::Scene& scene);

} // namespace gg::report
