#include "truth/closure.h"

#include "truth/albedo.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gg::truth {
namespace {

namespace f64 = glsl::f64;

double largest(const glm::dvec3& v) {
  return std::max({v.x, v.y, v.z});
}

Microfacets facets_of(const Interface& i) {
  return i.brushing ? Microfacets(i.brushing->alpha, i.smith)
                    : Microfacets(i.distribution, i.alpha, i.smith);
}

// Any two directions across n will do; this pair never divides by a small number.
glm::dvec3 across(const glm::dvec3& n) {
  const glm::dvec3 aside = std::abs(n.x) > 0.5 ? glm::dvec3(0, 1, 0) : glm::dvec3(1, 0, 0);
  return glm::normalize(glm::cross(aside, n));
}

} // namespace

Closure::Closure(const Interface& interface, const glm::dvec3& n, const glm::dvec3& wo,
                 const Arriving& arriving)
    : i_(interface), facets_(facets_of(interface)),
      coat_facets_(interface.distribution, interface.coat ? interface.coat->alpha : 0.0,
                   interface.smith),
      n_(n), wo_(wo), arriving_(arriving), dielectric_(1.0 - interface.metallic) {
  // An index of 0 or infinity (glTF's "always reflect", seen from either side) is a mirror.
  if (!(i_.eta > 0.0 && std::isfinite(i_.eta))) i_.eta = 0.0;
  refracts_ = i_.eta > 0.0 && dielectric_ > 0.0 && largest(i_.transmit) > 0.0;
  // At index 1 nothing bends light, however rough: what passes goes straight on, and is a delta.
  lobe_is_delta_ = facets_.smooth() || (i_.eta == 1.0 && i_.metallic == 0.0 && !i_.tinted);

  x_ = across(n);
  if (i_.brushing) {
    const glm::dvec3 along = i_.brushing->along - glm::dot(i_.brushing->along, n) * n;
    if (const double length = glm::length(along); length > 0.0) x_ = along / length;
  }
  y_ = glm::cross(n, x_);

  // How much each lobe sends on, guessed for the flat mirror. Any share between 0 and 1 is right on
  // average; a tenth at least to each bounds what a wrong guess costs.
  const Fresnel flat = fresnel(std::clamp(glm::dot(n, wo), 0.0, 1.0));
  const double before = largest(i_.diffuse), behind = largest(i_.diffuse_behind);
  double base = dielectric_ * (before + behind) * reaches_base(flat);
  if (i_.many_bounces)
    base += i_.metallic * largest(i_.bounce_tint)
            * (1.0 - i_.many_bounces->at(glm::dot(n, wo), i_.alpha));
  const double lobe = largest(flat.reflected) + dielectric_ * largest(i_.transmit) * flat.entering;
  if (behind > 0.0)
    behind_share_ =
        before > 0.0 || i_.many_bounces ? std::clamp(behind / (before + behind), 0.1, 0.9) : 1.0;
  diffuse_share_ = (before + behind) * dielectric_ > 0.0 || i_.many_bounces
                       ? std::clamp(base + lobe > 0.0 ? base / (base + lobe) : 0.5, 0.1, 0.9)
                       : 0.0;
  if (!i_.coat) return;
  coat_share_ = f64::coatShare(i_.coat->strength, std::clamp(glm::dot(i_.coat->n, wo), 0.0, 1.0));
  const double under = (1.0 - coat_share_) * (base + lobe);
  coat_chance_ =
      coat_share_ > 0.0 ? std::clamp(coat_share_ / (coat_share_ + under), 0.1, 0.9) : 0.0;
}

Microfacets::Pair Closure::pair(const f64::Facet& facet, const glm::dvec3& wi,
                                const glm::dvec3& h) const {
  const auto local = [&](const glm::dvec3& v) {
    return glm::dvec3(glm::dot(v, x_), glm::dot(v, y_), glm::dot(v, n_));
  };
  return {facet, local(wi), local(wo_), local(h)};
}

// The coat's lobe on top of what is under it, which it leaves 1 - coat_share_ of, in light and in chance.
void Closure::add_coat(const glm::dvec3& wi, Scattered& s) const {
  if (coat_chance_ == 0.0) return;
  s.f_cos *= 1.0 - coat_share_;
  s.pdf *= 1.0 - coat_chance_;
  // What the coat would send below the surface that it lies on is lost.
  if (coat_facets_.smooth() || !(glm::dot(wi, n_) > 0.0 && glm::dot(wi, i_.coat->n) > 0.0)) return;
  const f64::Facet facet = f64::reflectionFacet(wi, wo_, i_.coat->n, 0.0);
  if (!facet.exists) return;
  const Microfacets::Pair p{.facet = facet};
  const double lobe =
      f64::reflectionLobe(facet, coat_facets_.density(p), coat_facets_.shadowing_reflected(p));
  s.f_cos += glm::dvec3(coat_share_ * lobe * facet.wi.z);
  s.pdf += coat_chance_ * f64::reflectionPdf(facet, coat_facets_.pdf(p));
}

std::optional<Drawn> Closure::sample_coat(Random& random) const {
  const glm::dvec3 n = i_.coat->n, x = across(n), y = glm::cross(n, x);
  Drawn drawn;
  if (coat_facets_.smooth()) {
    drawn.wi = glm::normalize(f64::reflectAbout(wo_, n));
    drawn.weight = glm::dvec3(coat_share_ / coat_chance_);
    return drawn;
  }
  const glm::dvec3 m = coat_facets_.sample(
      {glm::dot(wo_, x), glm::dot(wo_, y), std::max(glm::dot(wo_, n), 0.0)}, random);
  drawn.wi = f64::reflectAbout(wo_, glm::normalize(m.x * x + m.y * y + m.z * n));
  const double length = glm::length(drawn.wi);
  if (!(length > 0.0)) return std::nullopt;
  drawn.wi /= length;
  if (!(glm::dot(drawn.wi, n_) > 0.0)) return std::nullopt;
  const Scattered s = evaluate(drawn.wi);
  if (!(s.pdf > 0.0)) return std::nullopt;
  drawn.weight = s.f_cos / s.pdf;
  drawn.pdf = s.pdf;
  return drawn;
}

Closure::Fresnel Closure::fresnel(double c) const {
  Fresnel f;
  glm::dvec3 coat(0.0);
  const auto with_film = [&](const glm::dvec3& bare, const glm::dvec3& f0) {
    if (!i_.film) return bare;
    const glm::dvec3 base(f64::filmBaseIor(f0.x), f64::filmBaseIor(f0.y), f64::filmBaseIor(f0.z));
    const glm::dvec3 film = f64::filmFresnel(c, i_.film->ior, i_.film->thickness, base);
    return bare + (film - bare) * i_.film->share;
  };
  if (dielectric_ > 0.0) {
    if (i_.tinted) {
      // Schlick's angle is the one on the outside, in air; from inside it follows from Snell's law.
      const double g = f64::fresnelG(c, i_.eta);
      const bool total = i_.eta > 0.0 && i_.eta < 1.0 && !(g > 0.0);
      const double outside = i_.eta > 0.0 && i_.eta < 1.0 ? g / i_.eta : c;
      coat = total
                 ? glm::dvec3(1.0)
                 : i_.tinted->f0
                       + (glm::dvec3(i_.tinted->f90) - i_.tinted->f0) * f64::schlickWeight(outside);
      f.entering = 1.0 - largest(coat);
    } else {
      coat = glm::dvec3(f64::fresnelDielectricAt(c, i_.eta));
      f.entering = f64::fresnelTransmittedAt(c, i_.eta);
    }
    if (i_.film) {
      coat = with_film(coat,
                       i_.tinted ? i_.tinted->f0 : glm::dvec3(f64::fresnelNormalIncidence(i_.eta)));
      f.entering = 1.0 - largest(coat);
    }
    f.refracted = i_.film ? glm::dvec3(1.0) - coat : glm::dvec3(f.entering);
  }
  f.reflected = (dielectric_ * i_.coated) * coat;
  if (i_.metallic > 0.0) {
    const glm::dvec3 metal =
        i_.metal ? f64::fresnelConductorRgb(c, glm::dvec3(i_.metal->n), glm::dvec3(i_.metal->k))
                 : f64::fresnelSchlickRgb(c, i_.metal_f0);
    f.reflected += i_.metallic * with_film(metal, i_.metal_f0);
  }
  return f;
}

// Of what comes along wo: what the coat lets through to the base, or all where the base comes first.
double Closure::reaches_base(const Fresnel& f) const {
  return i_.coated < 1.0 ? 1.0 : f.entering;
}

// Both, if both are worth it; else one, each as often as it carries light.
Closure::Chances Closure::chances(const Fresnel& f) const {
  if (!refracts_) return {};
  const double reflected = largest(f.reflected);
  const double refracted = dielectric_ * largest(i_.transmit * f.refracted);
  if (arriving_.power * std::min(reflected, refracted) >= worth_following()) return {1.0, 1.0};
  const double sum = reflected + refracted;
  return sum > 0.0 ? Chances{reflected / sum, refracted / sum} : Chances{};
}

// f of light that has met more than one facet [KullaConty17].
glm::dvec3 Closure::bounced_often(double cos_i) const {
  const Albedo& e = *i_.many_bounces;
  return i_.metallic * i_.bounce_tint
         * f64::multipleScatteringF(e.at(cos_i, i_.alpha), e.at(glm::dot(n_, wo_), i_.alpha),
                                    e.mean(i_.alpha));
}

Scattered Closure::evaluate(const glm::dvec3& wi) const {
  Scattered s = evaluate_base(wi);
  add_coat(wi, s);
  return s;
}

Scattered Closure::evaluate_base(const glm::dvec3& wi) const {
  Scattered s;
  if (glm::dot(wi, n_) > 0.0) {
    const f64::Facet facet = f64::reflectionFacet(wi, wo_, n_, i_.eta);
    const bool grazing = !facet.exists; // wo on the horizon, or wi opposite to it
    const Fresnel f = fresnel(facet.woDotM);
    if (diffuse_share_ > 0.0) {
      s.f_cos += reaches_base(f) * dielectric_ * i_.diffuse * (facet.wi.z / std::numbers::pi);
      if (i_.many_bounces) s.f_cos += bounced_often(facet.wi.z) * facet.wi.z;
      s.pdf += diffuse_share_ * (1.0 - behind_share_) * facet.wi.z / std::numbers::pi;
    }
    if (lobe_is_delta_ || grazing) return s;
    const Microfacets::Pair p = pair(facet, wi, f64::reflectionHalf(wi, wo_));
    const double lobe =
        f64::reflectionLobe(facet, facets_.density(p), facets_.shadowing_reflected(p));
    s.f_cos += f.reflected * (lobe * facet.wi.z);
    s.pdf +=
        (1.0 - diffuse_share_) * chances(f).reflect * f64::reflectionPdf(facet, facets_.pdf(p));
    return s;
  }
  if (behind_share_ > 0.0) return evaluate_behind(wi);
  if (lobe_is_delta_ || !refracts_) return s;
  const f64::Facet facet = f64::transmissionFacet(wi, wo_, n_, i_.eta);
  if (!facet.exists) return s;
  const Fresnel f = fresnel(facet.woDotM);
  const Microfacets::Pair p = pair(facet, wi, f64::transmissionHalf(wi, wo_, i_.eta));
  glm::dvec3 f_cos(
      f64::transmissionFCos(facet, facets_.density(p), facets_.shadowing_transmitted(p), i_.eta));
  // The snippet knows the exact 1 - F; a tinted coat lets pass what its own form leaves, and so does a film.
  if (i_.tinted || i_.film) {
    const double exact = f64::fresnelTransmitted(facet.woDotM, facet.g, i_.eta);
    f_cos = exact > 0.0 ? f_cos * (f.refracted / exact) : glm::dvec3(0.0);
  }
  s.f_cos = dielectric_ * f_cos * i_.transmit;
  s.pdf = (1.0 - diffuse_share_) * chances(f).refract
          * f64::transmissionPdf(facet, facets_.pdf(p), i_.eta);
  return s;
}

// KHR_materials_diffuse_transmission: light from the other side, as it would be scattered from this one.
Scattered Closure::evaluate_behind(const glm::dvec3& wi) const {
  Scattered s;
  const f64::Facet facet = f64::reflectionFacet(wi - 2.0 * glm::dot(wi, n_) * n_, wo_, n_, i_.eta);
  s.f_cos = reaches_base(fresnel(facet.woDotM)) * dielectric_ * i_.diffuse_behind
            * (facet.wi.z / std::numbers::pi);
  s.pdf = diffuse_share_ * behind_share_ * facet.wi.z / std::numbers::pi;
  return s;
}

std::optional<Drawn> Closure::sample_diffuse(Random& random) const {
  // Malley: uniform on the disc, lifted to the hemisphere, has density cos / pi.
  const glm::dvec2 u = random.uniform2();
  const double r = std::sqrt(u.x), phi = 2.0 * std::numbers::pi * u.y;
  Drawn drawn;
  drawn.transmitted = behind_share_ > 0.0 && random.uniform() < behind_share_;
  const double up = std::sqrt(1.0 - u.x);
  drawn.wi = glm::normalize(r * std::cos(phi) * x_ + r * std::sin(phi) * y_
                            + (drawn.transmitted ? -up : up) * n_);
  const Scattered s = evaluate(drawn.wi);
  if (!(s.pdf > 0.0)) return std::nullopt;
  drawn.weight = s.f_cos / s.pdf;
  drawn.pdf = s.pdf;
  return drawn;
}

// The whole of a smooth lobe: [Walter07] eq. 39 and 40.
std::optional<Drawn> Closure::sample_delta(bool reflect, const Fresnel& f, double chance) const {
  Drawn drawn;
  // Under a coat as much as that leaves, as often as it is not drawn.
  const double chosen =
      (1.0 - diffuse_share_) * chance * (1.0 - coat_chance_) / (1.0 - coat_share_);
  if (reflect) {
    drawn.wi = glm::normalize(f64::reflectAbout(wo_, n_));
    drawn.weight = f.reflected / chosen;
    return drawn;
  }
  const glm::dvec3 wi = f64::refractAbout(wo_, n_, i_.eta);
  if (wi == glm::dvec3(0.0)) return std::nullopt;
  drawn.wi = glm::normalize(wi);
  drawn.transmitted = true;
  // Radiance changes with the square of the index: shaders/bsdf/transmission.glsl.
  drawn.weight = i_.transmit * f.refracted * (dielectric_ / (i_.eta * i_.eta * chosen));
  return drawn;
}

std::optional<Drawn> Closure::sample_facet(bool reflect, const glm::dvec3& wm, const Fresnel& f,
                                           double chance) const {
  // At index 1 what passes goes straight on, whichever facet it met.
  if (lobe_is_delta_ || (!reflect && i_.eta == 1.0)) return sample_delta(reflect, f, chance);
  Drawn drawn;
  drawn.transmitted = !reflect;
  drawn.wi = reflect ? f64::reflectAbout(wo_, wm) : f64::refractAbout(wo_, wm, i_.eta);
  if (drawn.wi == glm::dvec3(0.0)) return std::nullopt;
  drawn.wi = glm::normalize(drawn.wi);
  // A single facet does not send light to the wrong side; what would go there is lost.
  if ((glm::dot(drawn.wi, n_) > 0.0) != reflect) return std::nullopt;
  const Scattered s = evaluate(drawn.wi);
  if (!(s.pdf > 0.0)) return std::nullopt;
  drawn.weight = s.f_cos / s.pdf;
  drawn.pdf = s.pdf;
  return drawn;
}

Draws Closure::sample(Random& random) const {
  Draws draws;
  const auto add = [&](const std::optional<Drawn>& drawn) {
    if (drawn) draws.add(*drawn);
  };
  if (coat_chance_ > 0.0 && random.uniform() < coat_chance_) {
    add(sample_coat(random));
    return draws;
  }
  if (diffuse_share_ > 0.0 && random.uniform() < diffuse_share_) {
    add(sample_diffuse(random));
    return draws;
  }
  glm::dvec3 wm = n_;
  if (!lobe_is_delta_) {
    const glm::dvec3 local(glm::dot(wo_, x_), glm::dot(wo_, y_), std::max(glm::dot(wo_, n_), 0.0));
    const glm::dvec3 m = facets_.sample(local, random);
    wm = glm::normalize(m.x * x_ + m.y * y_ + m.z * n_);
  }
  const double c = glm::dot(wo_, wm);
  if (!(c >= 0.0)) return draws; // a facet that wo sees from behind (drawn by D alone)
  const Fresnel f = fresnel(std::min(c, 1.0));
  const Chances follow = chances(f);
  const bool reflect = follow.both() || !(random.uniform() >= follow.reflect);
  if (reflect) add(sample_facet(true, wm, f, follow.reflect));
  if (!reflect || follow.both()) add(sample_facet(false, wm, f, follow.refract));
  return draws;
}

} // namespace gg::truth
