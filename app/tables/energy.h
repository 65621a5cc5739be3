// The energy of the reflection lobe: how much a surface that reflects everything sends back, and at which angles its facets
// do it, so that any Fresnel reflectance can be averaged over them.
#pragma once

#include "tables/lobe.h"

#include <functional>
#include <string>
#include <vector>

namespace gg::tables {

// albedo (share1 F(cos1) + (1 - share1) F(cos2)) stands for the lobe's albedo with the reflectance F, for every F.
struct EnergyCell {
  double albedo = 1.0, cos1 = 0.0, cos2 = 0.0, share1 = 0.5;
};

// The distribution of cos = wo . wm over the lobe's energy, in bins that know their own mean angle.
class FacetAngles {
public:
  explicit FacetAngles(const std::vector<LobeSample>& lobe);
  double albedo() const { return albedo_; }
  double mean() const { return mean_; }
  double deviation() const { return deviation_; }
  double integral(const std::function<double(double)>& reflectance) const;

private:
  struct Bin {
    double weight = 0.0, cos = 0.0;
  };
  std::vector<Bin> bins_;
  double albedo_ = 0.0, mean_ = 0.0, deviation_ = 0.0;
};

// Reflectances that the two angles are fitted to and judged by: Schlick's edge, dielectrics from 1.1 to 2.42, metals.
struct Reflectance {
  std::string name;
  std::function<double(double)> at; // of cos
};
const std::vector<Reflectance>& reflectances();

// The exact albedo for every reflectance above it is close to. `count` squared points.
EnergyCell fit_energy(const Model& model, double alpha, double cos_theta, int count);

} // namespace gg::tables
