// Presets put on materials: from the command line, and from glTF extras.
//
// Command line: --material 'NAME=PRESET[,KEY=VALUE...]'. NAME is a material's name, '#3' for the
// fourth material of the file, or '*' for all. 'NAME=,KEY=VALUE...' changes the material as it is.
//
// glTF: "extras": { "groundglass": { "preset": "gold", "alpha": 0.2, "distribution": "beckmann" } }
// in a material, with the same keys; colours are arrays of three numbers. Without "preset", the
// keys change the material as it is.
//
// A conductor or dielectric replaces the material's colour, metalness, roughness, transparency and
// their textures, and keeps its normal and occlusion maps; a finish only sets the width.
//
// KEY                   VALUE
// alpha                 width of D, 0..1, in place of roughness²
// roughness             glTF's, 0..1: alpha is its square
// finish                a finish's name
// back_alpha            width of D where light leaves a solid, 0..1
// distribution          ggx, beckmann, phong
// color                 what the surface (or a clear solid) is tinted with: R/G/B linear, or #rrggbb
// ior                   at least 1
// thickness             of a volume, in the mesh's units; 0 makes it thin-walled
// attenuation_distance  metres until white has become attenuation_color
// attenuation_color     as color
// dispersion            20 / Abbe number
// anisotropy            strength of brushing, 0..1 (KHR_materials_anisotropy)
// anisotropy_rotation   degrees from the tangent, counter-clockwise
// clearcoat             0..1; clearcoat_roughness 0..1
// iridescence           share with a thin film, 0..1; iridescence_ior at least 1; iridescence_thickness in nanometres
#pragma once

#include "core/error.h"
#include "scene/scene.h"

#include <string>
#include <utility>
#include <vector>

namespace gg::scene {

// Applies one --material option. Throws Error(usage) that lists what there is for an unknown
// material, preset, key or value; the scene is then as it was.
void apply_material(Scene& scene, const std::string& spec);

// A preset and its settings, from either source.
struct Setting {
  std::string preset; // may be empty
  std::vector<std::pair<std::string, std::string>> options;
  std::string where;               // for messages
  ExitCode code = ExitCode::usage; // of the errors
};

// Changes one material. `extent` is the shortest side of what it covers, in mesh units: the
// thickness that a clear solid is given to start from. Throws Error(setting.code).
void apply_setting(const Setting& setting, float extent, Material& material);

// The shortest side of the box around each primitive that a material covers; 0 if it covers none.
float extent_of(const Scene& scene, Index material);

} // namespace gg::scene
