// How one interface scatters: reflection and refraction by microfacets over a diffuse base, for a
// given viewer. Directions are world, unit and away from the surface (shaders/bsdf: wo, wi, wm, n).
#pragma once

#include "truth/microfacets.h"

#include <array>

namespace gg::truth {

class Albedo;

// Schlick's form for a dielectric whose reflectance is given as a colour (KHR_materials_specular).
struct TintedReflectance {
  glm::dvec3 f0{0.04};
  double f90 = 1.0;
};

// A clear layer over the rest (shaders/bsdf/clearcoat.glsl).
struct Coat {
  double strength = 0.0, alpha = 0.0;
  glm::dvec3 n{0.0}; // its own normal, dot(n, wo) >= 0
};

// A film on the reflecting substrate (shaders/bsdf/thin_film.glsl). Share of the surface; nanometres.
struct ThinFilm {
  double share = 0.0, ior = 1.3, thickness = 0.0;
};

// GGX along a direction, where it is not alpha (glTF's brushed surfaces).
struct Brushing {
  glm::dvec2 alpha{0.0}; // along, across
  glm::dvec3 along{0.0}; // unit, perpendicular to n
};

// What the interface is made of, as seen from the viewer's side.
struct Interface {
  scene::Distribution distribution = scene::Distribution::ggx;
  double alpha = 0.0; // width of D, in [0, 1]
  Smith smith = Smith::separable;
  double eta = 1.5; // dielectric: n_far / n_near; 0 reflects everything
  std::optional<TintedReflectance> tinted;
  double metallic = 0.0;                 // share of the metal, [0, 1]
  glm::dvec3 metal_f0{1.0};              // the metal by Schlick's form, or
  std::optional<scene::Conductor> metal; // by its complex index over that of the near side
  // Gives back what the metal's facets lose to each other; nothing: they lose it. And the colour
  // that each of its bounces takes on.
  const Albedo* many_bounces = nullptr;
  glm::dvec3 bounce_tint{0.0};
  glm::dvec3 diffuse{0.0};        // albedo of the base, all shares included
  glm::dvec3 diffuse_behind{0.0}; // the same of light that it sends to its other side
  // Share of the dielectric whose coat wo meets. From outside the coat lies over all of it. From
  // within a solid opaque parts of the base come first and hide it: the clear share is left.
  double coated = 1.0;
  glm::dvec3 transmit{0.0}; // factor on what is refracted, all shares included
  std::optional<Coat> coat;
  std::optional<ThinFilm> film;
  std::optional<Brushing> brushing;
};

struct Scattered {
  glm::dvec3 f_cos{0.0}; // f |wi . n|, for radiance seen along wo; 1/sr. Without deltas
  double pdf = 0.0;      // with which sample() draws wi, 1/sr. Without deltas
};

struct Drawn {
  glm::dvec3 wi{0.0};
  glm::dvec3 weight{0.0}; // f_cos / pdf
  double pdf = 0.0;       // 1/sr; 0 for a delta
  bool transmitted = false;
};

// The directions in which a path goes on: none if it is absorbed, two if it is split.
class Draws {
public:
  void add(const Drawn& drawn) { of_[count_++] = drawn; }
  const Drawn* begin() const { return of_.data(); }
  const Drawn* end() const { return of_.data() + count_; }
  bool empty() const { return count_ == 0; }

private:
  std::array<Drawn, 2> of_;
  std::size_t count_ = 0;
};

// The path to an interface: the power that it carries, of what a camera's path starts with, and how often it was
// scattered before.
struct Arriving {
  double power = 0.0; // in [0, 1]; 0: it is never split
  int bounces = 0;
};

// Of the power that a camera's path starts with: what is worth following by itself. A path that
// carries more is never ended by chance, and is split where both parts would carry as much. Behind a
// rough interface, where light is gathered, less is: there branches cost more than they tell from the third on. A smooth one
// sends on whatever light there is, and what few paths find would be fireflies.
inline double worth_following(bool smooth, int bounces) {
  constexpr double least = 1.0 / 64.0;
  if (smooth || bounces == 0) return least;
  return bounces == 1 ? 1.0 / 16.0 : 1.0 / 4.0;
}

class Closure {
public:
  // n: unit, dot(n, wo) >= 0.
  Closure(const Interface& interface, const glm::dvec3& n, const glm::dvec3& wo,
          const Arriving& arriving = {});

  Scattered evaluate(const glm::dvec3& wi) const;
  // Directions with a density near that of f_cos. Each counts whole, with its weight.
  Draws sample(Random& random) const;
  // True if nothing but deltas scatter: evaluate() is 0 everywhere.
  bool only_deltas() const {
    return lobe_is_delta_ && diffuse_share_ == 0.0
           && (coat_chance_ == 0.0 || coat_facets_.smooth());
  }

  struct Fresnel {
    glm::dvec3 reflected{0.0}; // by the coat or the metal
    double entering = 0.0;     // what passes the dielectric coat: 1 - F, 0 past the critical angle
    glm::dvec3 refracted{0.0}; // the same per channel, which a film tells apart
  };
  // At a facet that wo meets at this angle.
  Fresnel fresnel(double cos_near) const;
  const Interface& interface() const { return i_; }
  double worth_following() const {
    return truth::worth_following(lobe_is_delta_, arriving_.bounces);
  }
  const glm::dvec3& n() const { return n_; }

private:
  double reaches_base(const Fresnel& fresnel) const;
  Microfacets::Pair pair(const glsl::f64::Facet& facet, const glm::dvec3& wi,
                         const glm::dvec3& h) const;
  Scattered evaluate_base(const glm::dvec3& wi) const;
  Scattered evaluate_behind(const glm::dvec3& wi) const;
  void add_coat(const glm::dvec3& wi, Scattered& s) const;
  std::optional<Drawn> sample_coat(Random& random) const;
  // Probabilities of following what a facet reflects and what it refracts.
  struct Chances {
    double reflect = 1.0, refract = 0.0;
    bool both() const { return reflect == 1.0 && refract == 1.0; }
  };
  Chances chances(const Fresnel& fresnel) const;
  glm::dvec3 bounced_often(double cos_i) const;
  std::optional<Drawn> sample_diffuse(Random& random) const;
  std::optional<Drawn> sample_delta(bool reflect, const Fresnel& fresnel, double chance) const;
  std::optional<Drawn> sample_facet(bool reflect, const glm::dvec3& wm, const Fresnel& fresnel,
                                    double chance) const;

  Interface i_;
  Microfacets facets_, coat_facets_;
  glm::dvec3 n_, x_, y_, wo_;
  Arriving arriving_;
  double dielectric_; // share of what is not metal
  bool refracts_;     // light can pass
  bool lobe_is_delta_;
  double coat_share_ = 0.0, coat_chance_ = 0.0; // of light, and of sampling
  double diffuse_share_; // probability of drawing by the cosine: for the base and for many bounces
  double behind_share_ = 0.0; // of that: of drawing on the other side
};

} // namespace gg::truth
