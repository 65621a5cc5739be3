// Materials known by name: metals by their complex index, dielectrics by their index, finishes by
// their width.
#pragma once

#include "scene/scene.h"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace gg::scene {

enum class PresetKind { conductor, dielectric, finish };

struct Preset {
  std::string_view name;
  PresetKind kind;
  std::string_view source;               // of its numbers
  float alpha;                           // width of D where nothing else is said
  Conductor conductor{};                 // of a conductor
  float ior = 1.5f;                      // of a dielectric, at 587.6 nm
  float abbe = 0.0f;                     // its Abbe number; 0 = no dispersion
  float attenuation_distance = INFINITY; // metres
  glm::vec3 attenuation_color{1.0f};
};

// All of them: conductors, dielectrics, finishes, each by name.
std::span<const Preset> presets();

// Null if there is none of that name.
const Preset* find_preset(std::string_view name);

// The reflectance of a metal at normal incidence, per channel.
glm::vec3 normal_reflectance(const Conductor& conductor);

// "gold, silver, ...": the names of one kind, for messages and help.
std::string preset_names(PresetKind kind);

} // namespace gg::scene
