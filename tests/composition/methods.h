// Ways to draw what is seen through two rough interfaces, as lobes.
#pragma once

#include "composition/score.h"
#include "glsl/f64.h"

#include <optional>

namespace gg::composition_test {

namespace f64 = gg::glsl::f64;

// The constants of the rule that a model asks for.
f64::Widening widening(const tables::Model& model, int lobes);

// The rule of shaders/refraction, as composition_fetch.glsl has it: `first` lobes of the entry times `second` of the exit (1 or
// 2), merged to `kept` (2 of 4; 0: none are merged). Each first lobe meets its own exit.
struct Shape {
  int first = 2, second = 2, kept = 2;
};
std::vector<Lookup> composed(const Configuration& c, const Shape& shape,
                             const std::optional<f64::Widening>& constants = {},
                             bool curved = true);
// Share of the light that the exit reflects inside, by the rule.
double reflected_inside(const Configuration& c);

// The usual approximation: the second interface is not there. The Khronos sample viewer's and three.js' width, alpha scaled by the IOR, as
// the reflection lobe at normal incidence; energy 1 - F of the entry; the direction inside. With `leaves`, that of Snell's law
// at both faces.
std::vector<Lookup> standard_practice(const Configuration& c, bool leaves);

// First-order optics on the same tables: variances of the lobes added through Snell's Jacobian. Energies E1 E2, the latter at the
// lobe's own angle, or with `widened` as the rule has it.
std::vector<Lookup> added_variances(const Configuration& c, int lobes, bool widened);

// With the energy of the truth.
std::vector<Lookup> scaled(std::vector<Lookup> lobes, double energy);

} // namespace gg::composition_test
