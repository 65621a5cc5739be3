// Facets of a model drawn, and what shadowing lets pass of what they send on.
#pragma once

#include "tables/lobe.h"

namespace gg::tables {

// GGX by its visible normals, the others by D |wm . n|. `azimuth` turns about the view or the normal; `radius` leads from
// facets along it to those that lean far. Both in [0, 1).
glm::dvec3 draw_facet(const Model& model, double alpha, const glm::dvec3& wo, double azimuth,
                      double radius);

// The share of what meets the facet wm (all of it, Fresnel's factor aside) that shadowing and masking let pass from wo to
// wi, on either side: f cos over the density of wi, with wo's cosine divided out on paper.
double passed(const Model& model, double alpha, const glm::dvec3& wo, const glm::dvec3& wi,
              const glm::dvec3& wm);

} // namespace gg::tables
