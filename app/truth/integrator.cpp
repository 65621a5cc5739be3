#include "truth/integrator.h"

#include "truth/mis.h"
#include "truth/walk.h"

#include <cmath>
#include <numbers>

namespace gg::truth {

Integrator::Integrator(const scene::Scene& scene, const EnvironmentLight* environment,
                       const std::optional<glm::dvec3>& eye, const Settings& settings)
    : scene_(scene), environment_(environment), settings_(settings), geometry_(scene),
      media_(scene, geometry_), surfaces_(scene) {
  if (eye) around_eye_.inside = solids_around(*eye, geometry_, media_);
  for (const scene::Material& m : scene.materials) {
    passes_straight_ |= Surfaces::has_holes(m);
    passes_to_lights_ |= m.transmission > 0.0f;
    auto& albedo = albedos_[static_cast<std::size_t>(m.distribution)];
    if (settings.multiple_scattering && !m.unlit && !albedo)
      albedo.emplace(m.distribution, settings.smith);
  }
  passes_straight_ |= !media_.all_bend();
  passes_to_lights_ |= passes_straight_;
}

Sample Integrator::trace(const Ray& camera_ray, Random& random) const {
  Walk walk{.random = random};
  walk.paths.push_back({.ray = camera_ray, .from = camera_ray.origin, .where = around_eye_});
  while (true) {
    if (!walk.at_surfaces.empty()) {
      const auto [path, intersection] = std::move(walk.at_surfaces.back());
      walk.at_surfaces.pop_back();
      scatter(walk, path, intersection);
    } else if (!walk.paths.empty()) {
      const Path path = walk.paths.back();
      walk.paths.pop_back();
      advance(walk, path);
    } else {
      return walk.sample;
    }
  }
}

// To the next surface, past those that are not there where the path meets them.
void Integrator::advance(Walk& walk, Path path) const {
  while (true) {
    const std::optional<Hit> hit = geometry_.intersect(path.ray);
    if (!hit)
      return walk.sample.object == 0 ? add_background(walk, path) : add_environment(walk, path);
    const glm::dvec3 direction = path.ray.direction;
    const Crossing crossing =
        cross(*hit, direction, path.where, geometry_, media_, surfaces_, walk.random, Holes::drawn);
    const SolidId medium = media_.at(crossing.before.inside);
    path.throughput *= media_.transmittance(medium, glm::distance(path.from, hit->position));
    path.from = hit->position;
    path.ray = {geometry_.leave(*hit, direction), direction};
    if (!crossing.hit) {
      path.where = crossing.beyond;
      continue;
    }
    if (walk.sample.object == 0) walk.sample.object = 1 + crossing.hit->part->instance;

    Intersection intersection{.surface = surfaces_.read(*crossing.hit, -direction),
                              .wo = -direction};
    const Surface& surface = intersection.surface;
    if (surface.kind == SurfaceKind::unlit) {
      add(walk, path, path.throughput * surface.base_color);
      return;
    }
    add(walk, path, path.throughput * surface.emissive);

    intersection.before = crossing.before;
    intersection.beyond = crossing.beyond;
    const SolidId next = media_.at(intersection.beyond.inside);
    if (settings_.transport == Transport::surface_only) path.open = surface.occlusion;
    const bool splits =
        path.channel == white && (media_.disperses(medium) || media_.disperses(next));
    if (!splits) return meet(walk, path, intersection, medium, next);
    for (int c = 0; c < 3; ++c) {
      Path one = path;
      one.channel = c;
      one.throughput = glm::dvec3(0.0);
      one.throughput[c] = path.throughput[c];
      if (path.throughput[c] > 0.0) meet(walk, one, intersection, medium, next);
    }
    return;
  }
}

void Integrator::meet(Walk& walk, Path path, Intersection& intersection, SolidId medium,
                      SolidId next) const {
  intersection.ior_before = media_.ior(medium, path.channel);
  intersection.ior_beyond = intersection.solid()
                                ? media_.ior(next, path.channel)
                                : static_cast<double>(intersection.surface.material->ior);
  if (intersection.solid())
    if (const auto passed = unbent(intersection.surface, medium, next, path.channel)) {
      path.throughput *= *passed;
      path.where = intersection.beyond;
      walk.paths.push_back(path);
      return;
    }
  scatter(walk, path, intersection);
}

// What a solid's boundary lets straight through if it neither bends nor reflects light: all, inside
// something that displaces the solid, for then it is not there; its colour, between equal indices.
std::optional<glm::dvec3> Integrator::unbent(const Surface& s, SolidId medium, SolidId next,
                                             int channel) const {
  if (s.transmission != 1.0 || s.metallic != 0.0) return std::nullopt;
  if (next == medium) return glm::dvec3(1.0);
  if (media_.ior(next, channel) != media_.ior(medium, channel) || s.tinted_reflectance)
    return std::nullopt;
  return tint_of(s);
}

void Integrator::add_environment(Walk& walk, const Path& path) const {
  if (!environment_) return;
  const EnvironmentLight::Place place = environment_->place_of(path.ray.direction);
  const glm::dvec3 radiance = environment_->radiance(place);
  const double weight =
      path.pdf > 0.0 ? mis_share(path.pdf, environment_candidates * environment_->pdf(place)) : 1.0;
  add(walk, path, path.throughput * radiance * (weight * path.open));
}

void Integrator::add_background(Walk& walk, const Path& path) const {
  const auto& [sigma, plain] = settings_.background;
  if (!environment_ || (!plain && sigma == 0.0)) return add_environment(walk, path);
  if (plain) return add(walk, path, path.throughput * *plain);
  // A direction of the Gaussian, whose mean over the samples is the blurred environment. Box and Muller's two normal numbers, on
  // the plane that touches the sphere: to 0.7 % of the width at 0.15 rad.
  const double radius = sigma * std::sqrt(-2.0 * std::log(1.0 - walk.random.uniform()));
  const double turn = 2.0 * std::numbers::pi * walk.random.uniform();
  const glm::dvec3 d = path.ray.direction;
  const glm::dvec3 side = std::abs(d.y) < 0.9 ? glm::dvec3(0, 1, 0) : glm::dvec3(1, 0, 0);
  const glm::dvec3 x = glm::normalize(glm::cross(side, d)), y = glm::cross(d, x);
  const glm::dvec3 blurred = glm::normalize(d + radius * (std::cos(turn) * x + std::sin(turn) * y));
  add(walk, path, path.throughput * environment_->radiance(environment_->place_of(blurred)));
}

void Integrator::add(Walk& walk, const Path& path, const glm::dvec3& radiance) const {
  const double most = largest(radiance);
  const double part = most > settings_.clamp && path.scattered ? settings_.clamp / most : 1.0;
  walk.sample.radiance += part * radiance;
  walk.sample.clamped += (1.0 - part) * (radiance.x + radiance.y + radiance.z) / 3.0;
}

// Russian roulette: what is worth following by itself goes on, what carries less as often as it
// carries of that. Light that is caught in a lossless solid must stop too; from a length that few
// paths reach, one in fifty ends at each bounce.
bool Integrator::survives(Walk& walk, Path& path, double worth_following) const {
  constexpr int long_path = 64;
  constexpr double at_most = 0.98;
  ++path.bounces;
  const double chance =
      std::min(path.bounces < long_path ? 1.0 : at_most, path.power() / worth_following);
  if (chance == 1.0) return true;
  if (!(walk.random.uniform() < chance)) return false;
  path.throughput /= chance;
  return true;
}

Interface Integrator::interface_at(const Surface& s, double near_ior, double far_ior,
                                   const glm::dvec3& tint, bool from_within) const {
  Interface i = interface_of(s, near_ior, far_ior, settings_.smith, tint, from_within);
  if (settings_.multiple_scattering && i.metallic > 0.0 && i.alpha > 0.0) {
    i.many_bounces = &*albedos_[static_cast<std::size_t>(i.distribution)];
    i.bounce_tint = i.many_bounces->tint(i);
  }
  return i;
}

Closure Integrator::closure_at(const Intersection& intersection, const Arriving& arriving) const {
  using Face = Intersection::Face;
  const Surface& s = intersection.surface;
  const glm::dvec3 n = intersection.by_triangle ? s.geometric : s.n;
  if (intersection.face == Face::first) {
    // A wall tints what reaches its other side, once.
    const glm::dvec3 tint = intersection.solid() ? tint_of(s) : glm::dvec3(1.0);
    return Closure(interface_at(s, intersection.ior_before, intersection.ior_beyond, tint,
                                intersection.from_within()),
                   intersection.by_triangle ? face_viewer(n, intersection.wo) : n, intersection.wo,
                   arriving);
  }
  // A wall is one surface, of which the clear share is met once; a plate has two.
  Surface clear = s;
  clear.coat.reset();
  clear.film.reset();
  if (!intersection.from_within()) {
    clear.metallic = 0.0;
    clear.transmission = 1.0;
  }
  const bool far = intersection.face == Face::far;
  const glm::dvec3 tint = far ? s.base_color : glm::dvec3(1.0);
  return Closure(interface_at(clear, intersection.ior_beyond, intersection.ior_before, tint,
                              intersection.from_within()),
                 face_viewer(far ? n : -n, intersection.wo), intersection.wo, arriving);
}

void Integrator::scatter(Walk& walk, const Path& path, const Intersection& intersection) const {
  const Closure closure = closure_at(intersection, {path.power(), path.bounces});
  add_direct_light(walk, path, intersection, closure);
  for (const Drawn& drawn : closure.sample(walk.random))
    follow(walk, path, intersection, drawn, closure);
}

// From face to face of a plate, which stand its thickness apart: absorbed on the way, and as far aside.
void Integrator::cross_plate(Path& path, Intersection& m, const glm::dvec3& wi) const {
  if (!(m.surface.thickness > 0.0)) return;
  // A direction along the plate would never arrive. A thousandth of a right angle is longer than any
  // plate is wide.
  constexpr double least_cosine = 1e-3;
  const double distance =
      m.surface.thickness / std::max(std::abs(glm::dot(wi, m.surface.n)), least_cosine);
  const scene::Material& material = *m.surface.material;
  path.throughput *= transmittance(glm::dvec3(material.attenuation_color),
                                   distance / static_cast<double>(material.attenuation_distance));
  m.surface.hit.position += distance * wi;
}

void Integrator::follow(Walk& walk, Path path, const Intersection& m, const Drawn& drawn,
                        const Closure& closure) const {
  using Face = Intersection::Face;
  const bool alone = settings_.transport == Transport::surface_only;
  const bool across = drawn.transmitted;
  const bool refracted = across && m.surface.kind != SurfaceKind::opaque;
  const double eta = closure.interface().eta, eta2 = refracted ? eta * eta : 1.0;
  path.throughput *= drawn.weight;
  path.scattered = true;

  if (!m.leaves(across)) {
    path.scale *= eta2;
    Intersection within = m;
    within.face = m.face == Face::far ? Face::near : Face::far;
    within.wo = -drawn.wi;
    cross_plate(path, within, drawn.wi);
    if (survives(walk, path, closure.worth_following()))
      walk.at_surfaces.emplace_back(path, within);
    return;
  }
  if (!alone && !m.right_side(drawn.wi, across)) {
    if (m.by_triangle) return;
    // The power that was drawn is scattered again: without the change of radiance across an
    // interface that it does not cross this way.
    path.throughput *= eta2;
    walk.at_surfaces.emplace_back(path, m);
    walk.at_surfaces.back().second.by_triangle = true;
    return;
  }
  path.scale *= eta2;
  if (alone && across && m.solid()) path.throughput *= eta2;
  path.where = m.where_after(across);
  path.ray = {geometry_.leave(m.surface.hit, drawn.wi), drawn.wi};
  path.from = m.surface.hit.position;
  const bool gathered = alone || media_.ior(media_.at(path.where.inside), path.channel) == 1.0;
  path.pdf = gathered ? drawn.pdf : 0.0;
  if (!survives(walk, path, closure.worth_following())) return;
  if (alone)
    add_environment(walk, path);
  else
    walk.paths.push_back(path);
}

} // namespace gg::truth
