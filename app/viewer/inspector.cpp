#include "viewer/inspector.h"

#include "glsl/f64.h"
#include "needs/features.h"
#include "needs/tables.h"
#include "tables/lookup.h"
#include "truth/surface.h"

#include <glm/gtc/matrix_inverse.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gg::viewer {
namespace {

namespace f64 = gg::glsl::f64;
constexpr double pi = std::numbers::pi;

// The reflectance of a material as a dielectric's or a metal's, of the mean of its channels.
struct Reflector {
  double eta = 1.5; // 0: a metal of n + i k
  double n = 0.0, k = 0.0;
  double at(double cosine) const {
    return eta > 0.0 ? f64::fresnelDielectricAt(cosine, eta) : f64::fresnelConductor(cosine, n, k);
  }
};

Reflector reflector_of(const truth::Surface& s) {
  const auto mean = [](const glm::dvec3& v) { return (v.x + v.y + v.z) / 3.0; };
  const scene::Material& m = *s.material;
  if (m.conductor)
    return {
        .eta = 0.0, .n = mean(glm::dvec3(m.conductor->n)), .k = mean(glm::dvec3(m.conductor->k))};
  if (s.metallic >= 0.5) {
    // Of a colour at normal incidence alone: the real IOR that reflects as much.
    const double root = std::sqrt(std::min(mean(s.base_color), 0.99));
    return {.eta = 0.0, .n = (1.0 + root) / (1.0 - root), .k = 0.0};
  }
  return {.eta = static_cast<double>(m.ior)};
}

// What the path tracer would read where the cursor is.
truth::Surface surface_at(const scene::Scene& scene, const Picked& hit, const glm::dvec3& wo) {
  const scene::Instance& instance = scene.instances[static_cast<std::size_t>(hit.instance)];
  const scene::Primitive& primitive = scene.meshes[static_cast<std::size_t>(instance.mesh)]
                                          .primitives[static_cast<std::size_t>(hit.primitive)];
  const glm::dmat4 world(instance.world);
  const truth::Part part{.primitive = &primitive,
                         .material = &scene.materials[static_cast<std::size_t>(hit.material)],
                         .instance = hit.instance,
                         .material_index = hit.material,
                         .world_from_mesh = world,
                         .normal_from_mesh = glm::inverseTranspose(glm::dmat3(world)),
                         .mirrored = instance.mirrored};
  const truth::Hit at{.part = &part,
                      .vertices = {hit.vertices[0], hit.vertices[1], hit.vertices[2]},
                      .weights = hit.weights,
                      .position = hit.position,
                      .normal = hit.normal};
  truth::Surface surface = truth::Surfaces(scene).read(at, wo);
  surface.hit.part = nullptr; // it ends here
  return surface;
}

// From the viewer's side, who is at `incidence` to the left.
f64::vec3 towards(double angle, double side) {
  return {-std::sin(angle), 0.0, side * std::cos(angle)};
}

std::vector<LobeValue> exact_lobe(const f64::BsdfSurface& surface, double incidence,
                                  bool correlated) {
  constexpr int steps = 720; // a quarter of a degree
  const f64::vec3 wo(std::sin(incidence), 0.0, std::cos(incidence)), n(0.0, 0.0, 1.0);
  std::vector<LobeValue> values;
  for (int i = 0; i <= steps; ++i) {
    const double angle = pi * (static_cast<double>(i) / steps - 0.5);
    const f64::vec3 wi = towards(angle, surface.transmits ? -1.0 : 1.0);
    const f64::BsdfValues v = f64::bsdfValues(f64::bsdfFacet(wi, wo, n, surface), surface);
    values.push_back({angle, correlated ? v.fCorrelated * std::abs(wi.z) : v.fCos});
  }
  return values;
}

InspectedLobe reflected_lobe(const tables::Model& model, const Reflector& reflects, int lobes,
                             double cosine, double alpha) {
  InspectedLobe lobe;
  const f64::LobeEnergy energy = tables::reflection_energy_at(model, cosine, alpha);
  const double mean = f64::lobeMean(energy, reflects.at(energy.cos1), reflects.at(energy.cos2));
  lobe.energy = energy.albedo * mean;
  const double edge = f64::edgeShare(reflects.at(1.0), mean);
  const f64::vec3 n(0.0, 0.0, 1.0), mirror(-std::sqrt(1.0 - cosine * cosine), 0.0, cosine);
  for (int k = 0; k < lobes; ++k) {
    const auto texel = tables::reflection_texel_at(model, k, lobes, cosine, alpha, edge);
    const f64::vec3 direction = f64::lobeDirection(mirror, n, texel[0]);
    lobe.fitted.push_back({std::atan2(-direction.x, direction.z), texel[1] * alpha, texel[2]});
  }
  return lobe;
}

InspectedLobe passing_lobe(const tables::Model& model, double eta, int lobes, double cosine,
                           double alpha) {
  InspectedLobe lobe;
  lobe.energy = tables::interface_energy_at(model, cosine, alpha, eta).transmitted;
  for (int k = 0; k < lobes; ++k) {
    const f64::InterfaceLobe found = tables::interface_lobe_at(model, k, lobes, cosine, alpha, eta);
    lobe.fitted.push_back({found.angle, found.sigma, found.weight});
  }
  return lobe;
}

glm::dvec3 refracted(const glm::dvec3& towards, const glm::dvec3& normal, double eta) {
  const f64::vec3 wi = f64::refractAbout(-towards, normal, eta);
  return {wi.x, wi.y, wi.z};
}

// From where the ray enters to what it sees behind.
Inspection::Exit exit_of(const scene::Scene& scene, const Picked& hit, const glm::dvec3& normal,
                         const glm::dvec3& direction, double eta) {
  Inspection::Exit exit;
  const glm::dvec3 inside = refracted(direction, normal, eta);
  const Ray within{hit.position, glm::vec3(inside)};
  const auto back = pick(scene, within, {.instance = hit.instance, .back_faces = true});
  if (!back) {
    exit.reflected = true;
    return exit;
  }
  exit.length = static_cast<double>(back->distance);
  exit.position = back->position;
  const glm::dvec3 out = refracted(inside, -glm::dvec3(back->normal), 1.0 / eta);
  if (out == glm::dvec3(0.0)) {
    exit.reflected = true;
    return exit;
  }
  // A little on, so that the face that it leaves by is behind.
  const float step = 1e-4f * scene.bounds.radius();
  const Ray behind{back->position + step * glm::vec3(out), glm::vec3(out)};
  if (const auto met = pick(scene, behind)) {
    exit.meets = met->instance;
    exit.distance = static_cast<double>(met->distance + step);
  }
  return exit;
}

} // namespace

double InspectedLobe::fit_at(double angle) const {
  double sum = 0.0;
  for (const FittedLobe& lobe : fitted) {
    if (!(lobe.sigma > 0.0)) continue;
    const double off = (angle - lobe.angle) / lobe.sigma;
    sum += energy * lobe.weight * std::exp(-0.5 * off * off) / (2.0 * pi * lobe.sigma * lobe.sigma);
  }
  return sum;
}

std::optional<Inspection> inspect(const scene::Scene& scene, const Ray& ray, needs::Method method,
                                  bool correlated_smith) {
  const auto hit = pick(scene, ray);
  if (!hit) return std::nullopt;
  const scene::Material& material = scene.materials[static_cast<std::size_t>(hit->material)];
  const glm::dvec3 direction = glm::normalize(glm::dvec3(ray.direction));
  const truth::Surface seen = surface_at(scene, *hit, -direction);
  Inspection found;
  found.instance = hit->instance;
  found.material = hit->material;
  found.unlit = material.unlit;
  if (found.unlit) return found;
  // Below, a surface is smooth for the tables and for a plot of it.
  constexpr double least_alpha = 1e-3;
  found.alpha = seen.alpha;
  if (seen.coat) found.coat = seen.coat->strength, found.coat_alpha = seen.coat->alpha;
  found.film = seen.film.has_value();
  found.brushed = seen.brushing.has_value();
  found.mixed = !material.conductor && seen.metallic > 0.0 && seen.metallic < 1.0;
  const double alpha = std::max(found.alpha, least_alpha);
  // The horizon itself has no plot.
  const double cosine = std::clamp(glm::dot(seen.n, -direction), 1e-3, 1.0);
  found.incidence = std::acos(cosine);
  const Reflector reflects = reflector_of(seen);
  found.eta = reflects.eta;
  found.fresnel = reflects.at(cosine);

  const tables::Model model = needs::model_of(material, correlated_smith);
  const bool correlated = model.smith == tables::Smith::correlated;
  const int lobes = std::max(needs::reflection_lobes(method, model), 1);
  f64::BsdfSurface surface{
      false,
      static_cast<int>(material.distribution),
      material.distribution == scene::Distribution::phong ? f64::phongExponent(alpha) : alpha,
      reflects.eta,
      reflects.n,
      reflects.k};
  found.reflected = reflected_lobe(model, reflects, lobes, cosine, alpha);
  found.reflected.exact = exact_lobe(surface, found.incidence, correlated);
  // An IOR of 1 bends nothing: no lobe.
  if (!needs::is_refractive(material) || found.eta == 1.0) return found;
  surface.transmits = true;
  found.passes =
      passing_lobe(model, found.eta, std::max(needs::interface_lobes(method), 1), cosine, alpha);
  found.passes.exact = exact_lobe(surface, found.incidence, correlated);
  if (material.thickness > 0.0f) found.leaves = exit_of(scene, *hit, seen.n, direction, found.eta);
  return found;
}

} // namespace gg::viewer
