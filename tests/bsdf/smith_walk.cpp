#include "bsdf/smith_walk.h"

#include <random>

namespace gg::bsdf_test {
namespace {

namespace f64 = gg::glsl::f64;
using f64::vec2;
using f64::vec3;

constexpr int longest_walk = 1000; // facets; what is left after that many is counted as trapped

class Walk {
public:
  Walk(double alpha, std::uint64_t seed) : alpha_(alpha), random_(seed) {}

  double uniform() { return std::uniform_real_distribution<double>(0.0, 1.0)(random_); }

  // Starts above the surface, going down along -wo.
  void start(vec3 wo) {
    direction_ = -wo;
    rank_ = 1.0;
    above_ = true;
  }

  // Moves on to the next facet; false if there is none and the light leaves. Heights are told by
  // their rank (the share of the surface that lies lower), which is all that Smith's model knows of
  // them: along a direction of slope term Lambda the light survives from rank a to rank b with
  // probability (a / b)^Lambda, for Lambda of either sign.
  bool reach_next() {
    const double lambda = signed_lambda(direction_);
    // Level travel (Lambda without bound) meets a facet at once.
    rank_ = std::abs(lambda) > 1e12 ? rank_ : rank_ / std::pow(1.0 - uniform(), 1.0 / lambda);
    return rank_ < 1.0;
  }

  vec3 facet() { return f64::ggxSampleVisible(-direction_, vec2(alpha_), {uniform(), uniform()}); }

  void reflect(vec3 m) { direction_ = f64::reflectAbout(-direction_, m); }

  // Into the other medium, whose surface is the same one upside down.
  void refract(vec3 m, double eta) {
    const vec3 w = f64::refractAbout(-direction_, m, eta);
    direction_ = {w.x, w.y, -w.z};
    rank_ = 1.0 - rank_;
    above_ = !above_;
  }

  bool above() const { return above_; }
  vec3 travel() const { return direction_; }

private:
  double signed_lambda(vec3 w) const {
    const double root = std::sqrt(w.z * w.z + alpha_ * alpha_ * (w.x * w.x + w.y * w.y));
    return 0.5 * (root / w.z - 1.0); // upwards (root / z - 1) / 2, downwards -(root / |z| + 1) / 2
  }

  double alpha_;
  std::mt19937_64 random_;
  vec3 direction_{};
  double rank_ =
      1.0; // of the current height among all heights, seen from the medium that the light is in
  bool above_ = true;
};

vec3 incoming(double cos_theta) {
  return {std::sqrt(1.0 - cos_theta * cos_theta), 0.0, cos_theta};
}

} // namespace

WalkEnergy walk_dielectric(double cos_theta, double alpha, double eta, int walks,
                           std::uint64_t seed) {
  Walk walk(alpha, seed);
  WalkEnergy energy;
  const double share = 1.0 / walks;
  for (int i = 0; i < walks; ++i) {
    walk.start(incoming(cos_theta));
    int facets = 0;
    while (facets < longest_walk && walk.reach_next()) {
      const vec3 m = walk.facet();
      const double local_eta = walk.above() ? eta : 1.0 / eta;
      const double reflectance = f64::fresnelDielectricAt(f64::dot(-walk.travel(), m), local_eta);
      if (walk.uniform() < reflectance)
        walk.reflect(m);
      else
        walk.refract(m, local_eta);
      ++facets;
    }
    if (facets >= longest_walk)
      energy.trapped += share;
    else if (walk.above())
      (facets == 1 ? energy.reflected_once : energy.reflected_more) += share;
    else
      (facets == 1 ? energy.transmitted_once : energy.transmitted_more) += share;
  }
  return energy;
}

double walk_mirror(double cos_theta, double alpha, double reflectance, int walks,
                   std::uint64_t seed) {
  Walk walk(alpha, seed);
  double leaves = 0.0;
  for (int i = 0; i < walks; ++i) {
    walk.start(incoming(cos_theta));
    double power = 1.0;
    for (int facets = 0; facets < longest_walk && walk.reach_next(); ++facets) {
      walk.reflect(walk.facet());
      power *= reflectance;
    }
    leaves += power / walks;
  }
  return leaves;
}

} // namespace gg::bsdf_test
