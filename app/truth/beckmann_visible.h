// Sampling the normals of a Beckmann surface that a viewer sees.
#pragma once

#include "glsl/f64.h"
#include "truth/random.h"

namespace gg::truth {

// A microfacet normal with density G1(wo) D(wm) |wo . wm| / |wo . n|, with the exact (error
// function) G1. wo: local, n = +z, wo.z >= 0; alpha in (0, 1].
glm::dvec3 beckmann_sample_visible(const glm::dvec3& wo, double alpha, Random& random);

// That density, 1/sr, for the facet of a direction that was reflected or refracted from wo.
double beckmann_pdf_visible(const glsl::f64::Facet& facet, double alpha);

} // namespace gg::truth
