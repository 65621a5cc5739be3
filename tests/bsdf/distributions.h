// The three distributions behind one face, so that a property is written once and proved for each.
#pragma once

#include "glsl/f64.h"

#include <functional>
#include <string>
#include <vector>

namespace gg::bsdf_test {

namespace f64 = gg::glsl::f64;
using f64::Facet;
using f64::Tilt;
using f64::vec2;
using f64::vec3;

// One distribution at one width; Phong's is converted to its exponent here.
struct Distribution {
  std::string name;
  double alpha = 0;
  std::function<double(Tilt)> d, g1, pdf;
  std::function<double(Tilt, Tilt)> v; // separable G / (4 |wi.n| |wo.n|)
  std::function<vec3(vec2)> sample;    // wm of density pdf
};

Distribution ggx(double alpha);
Distribution beckmann(double alpha);
Distribution phong(double alpha);
// Every distribution at every width of the list; Phong ends at alpha 1, exponent 0.
std::vector<Distribution> distributions(std::vector<double> alphas);

// Unit vector at polar angle theta from +z and azimuth phi, in radians. theta beyond pi / 2 lies
// below.
vec3 direction(double theta, double phi);
constexpr double degree = 0.017453292519943295;
inline const vec3 up{0.0, 0.0, 1.0};

// f_r and f_t (for radiance) of a dielectric, through the public pieces.
double reflected(const Distribution& m, vec3 wi, vec3 wo, double eta);
double transmitted(const Distribution& m, vec3 wi, vec3 wo, double eta);

} // namespace gg::bsdf_test
