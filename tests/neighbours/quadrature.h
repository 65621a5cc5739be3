// Shares of lobes by brute force.
#pragma once

#include <glm/glm.hpp>

#include <functional>
#include <vector>

namespace gg::neighbours_test {

using glm::dvec3;

// The sphere's Gaussian exp(-l(l+1) sigma²/2): its density per steradian at an angle from its middle, tabulated from the series.
class HeatKernel {
public:
  explicit HeatKernel(double sigma);
  double at(double theta) const;

private:
  std::vector<double> values_; // even in theta from 0 to pi
};

// Its share within a cap of angular radius rho at the angle theta, by the series of Legendre polynomials.
double cap_share(double sigma, double rho, double theta);

// The share of a lobe about `direction` in the directions for which `is_met`.
double share_of(const HeatKernel& kernel, double sigma, const dvec3& direction,
                const std::function<bool(const dvec3&)>& is_met);

// The same with weight cos / pi about n.
double cosine_share_of(const dvec3& n, const std::function<bool(const dvec3&)>& is_met);

bool meets_rectangle(const dvec3& ray, const dvec3& centre, const dvec3& u, const dvec3& v);

} // namespace gg::neighbours_test
