// What the surface under the cursor does with light: its exact lobes, and the Gaussians that stand for them. Pure: no window, no
// device.
#pragma once

#include "needs/features.h"
#include "scene/scene.h"
#include "viewer/picking.h"

#include <glm/glm.hpp>

#include <optional>
#include <string>
#include <vector>

namespace gg::viewer {

// In the plane of incidence: `angle` from the normal of its side, radians, positive away from the viewer.
struct FittedLobe {
  double angle = 0.0, sigma = 0.0, weight = 0.0; // sigma in radians; weights of a lobe sum to 1
};
struct LobeValue {
  double angle = 0.0, value = 0.0; // f |cos|, 1/sr
};
struct InspectedLobe {
  double energy = 0.0; // of the fit: the share of the light
  std::vector<FittedLobe> fitted;
  std::vector<LobeValue> exact; // from -90 to 90 degrees
  // The fit's own f |cos| at an angle.
  double fit_at(double angle) const;
};

struct Inspection {
  scene::Index instance = scene::none, material = scene::none;
  bool unlit = false;     // it shows its colour: nothing of what follows is
  double alpha = 0.0;     // with what the material's maps say there
  double incidence = 0.0; // radians
  double eta = 0.0;       // the material's IOR over 1; 0 for metals
  // What lies over the surface and is left out of the lobes below: a coat (its share and width), a thin film. A brushed surface is
  // taken by its mean width.
  double coat = 0.0, coat_alpha = 0.0;
  bool film = false, brushed = false;
  bool mixed = false;   // of metal and dielectric: the lobes are of the one that there is more of
  double fresnel = 0.0; // F of the smooth surface; 1 - F is the rest
  InspectedLobe reflected, passes; // `passes` is empty where nothing does
  // Of glass with an inside: along the ray that Snell's law gives.
  struct Exit {
    double length = 0.0; // metres inside
    glm::vec3 position{0.0f};
    bool reflected = false;           // totally, or there is no way out
    scene::Index meets = scene::none; // the instance behind it; none: the environment
    double distance = 0.0;            // metres to it
  };
  std::optional<Exit> leaves;
};

// The Gaussians are those that the method reads; alpha, metal, colour and normal as maps and vertices have them. Nothing where the ray meets nothing. Throws Error(input) if
// the tables cannot be read.
std::optional<Inspection> inspect(const scene::Scene& scene, const Ray& ray, needs::Method method,
                                  bool correlated_smith);

} // namespace gg::viewer
