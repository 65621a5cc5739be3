#include "truth/integrator.h"

#include "truth/lights.h"

#include <algorithm>
#include <cmath>

namespace gg::truth {
namespace {

double largest(const glm::dvec3& v) {
  return std::max({v.x, v.y, v.z});
}

// The power heuristic [Veach97, 9.2.4] for one sample of density a against one of density b.
double share(double a, double b) {
  // By the ratio: a delta-like density does not overflow when it is squared.
  const double r = b / a;
  return 1.0 / (1.0 + r * r);
}

// Light that crosses a solid passes two interfaces, and is tinted by the base colour in all.
glm::dvec3 tint_of(const Surface& solid) {
  return glm::sqrt(solid.base_color);
}

} // namespace

// What has been followed so far. `pdf` is the density with which the last direction was drawn if
// direct light was gathered in the same place, 0 otherwise: then what the path meets counts whole.
struct Integrator::Path {
  Ray ray;
  Random& random;
  glm::dvec3 throughput{1.0}, radiance{0.0};
  Inside inside;
  double pdf = 0.0;
  double open =
      1.0; // factor on the environment: baked occlusion, where paths do not find their own
  double scale = 1.0; // product of eta² of the interfaces crossed: throughput * scale is power
  int bounces = 0;
};

// A path at a surface. A thin wall is two interfaces at one place; the path goes on between them
// until it leaves.
struct Integrator::Meeting {
  enum class Face {
    first, // where the path came from; the only one, except in a wall
    far,   // the wall's other interface, from inside
    near   // the first interface again, from inside
  };

  Surface surface;
  Face face = Face::first;
  glm::dvec3 wo{0.0};
  Inside before, beyond; // on this side of the surface and on the other
  double ior_before = 1.0, ior_beyond = 1.0;
  bool by_triangle = false; // shading normals gave no direction: the triangle's normal is used

  bool solid() const { return surface.kind == SurfaceKind::solid; }
  // Does a scattered ray leave the place, or stay in the wall?
  bool leaves(bool transmitted) const {
    return face == Face::first ? !transmitted || solid() : transmitted;
  }
  // To the other side of the surface, for a ray that leaves?
  bool crosses(bool transmitted) const {
    return face == Face::first ? transmitted : face == Face::far;
  }
  const Inside& inside_after(bool transmitted) const {
    return solid() && crosses(transmitted) ? beyond : before;
  }
  bool right_side(const glm::dvec3& wi, bool transmitted) const {
    const double above = glm::dot(wi, surface.geometric);
    return crosses(transmitted) ? above < 0.0 : above > 0.0;
  }
};

Integrator::Integrator(const scene::Scene& scene, const EnvironmentLight* environment,
                       const std::optional<glm::dvec3>& eye, const Settings& settings)
    : scene_(scene), environment_(environment), settings_(settings), geometry_(scene),
      media_(scene, geometry_), surfaces_(scene) {
  if (eye) around_eye_ = solids_around(*eye, geometry_, media_);
  for (const scene::Material& m : scene.materials)
    casts_clear_shadows_ |= Surfaces::has_holes(m) || m.transmission > 0.0f;
}

Sample Integrator::trace(const Ray& camera_ray, Random& random) const {
  Sample sample;
  Path path{.ray = camera_ray, .random = random, .inside = around_eye_};
  for (bool first = true;;) {
    const std::optional<Hit> hit = geometry_.intersect(path.ray);
    if (!hit) {
      add_environment(path);
      break;
    }
    const SolidId solid = media_.bounded_by(*hit->part);
    const bool enters = glm::dot(path.ray.direction, hit->normal) < 0.0;
    // A solid that is left was entered somewhere, if only through a hole in its mesh.
    if (solid != air && !enters && !path.inside.contains(solid)) path.inside.enter(solid);
    const SolidId medium = media_.at(path.inside);
    path.throughput *= media_.transmittance(medium, hit->distance);

    const glm::dvec3 direction = path.ray.direction;
    path.ray = {geometry_.leave(*hit, direction), direction};
    if (Surfaces::has_holes(*hit->part->material)
        && path.random.uniform() >= surfaces_.coverage(*hit))
      continue;
    if (first) sample.object = 1 + hit->part->instance;
    first = false;

    Meeting meeting{.surface = surfaces_.read(*hit, -direction), .wo = -direction};
    const Surface& surface = meeting.surface;
    if (surface.kind == SurfaceKind::unlit) {
      path.radiance += path.throughput * surface.base_color;
      break;
    }
    path.radiance += path.throughput * surface.emissive;

    meeting.before = meeting.beyond = path.inside;
    meeting.ior_before = media_.ior(medium);
    meeting.ior_beyond = static_cast<double>(surface.material->ior);
    if (meeting.solid()) {
      if (enters)
        meeting.beyond.enter(solid);
      else
        meeting.beyond.leave(solid);
      const SolidId next = media_.at(meeting.beyond);
      meeting.ior_beyond = media_.ior(next);
      if (const auto passed = unbent(surface, medium, next)) {
        path.throughput *= *passed;
        path.inside = meeting.beyond;
        continue;
      }
    }
    if (settings_.transport == Transport::surface_only) path.open = surface.occlusion;
    if (!scatter(path, meeting)) break;
    if (settings_.transport == Transport::surface_only) {
      add_environment(path);
      break;
    }
  }
  sample.radiance = path.radiance;
  return sample;
}

// What a solid's boundary lets straight through if it neither bends nor reflects light: all, inside
// something that displaces the solid, for then it is not there; its colour, between equal indices.
std::optional<glm::dvec3> Integrator::unbent(const Surface& s, SolidId medium, SolidId next) const {
  if (s.transmission != 1.0 || s.metallic != 0.0) return std::nullopt;
  if (next == medium) return glm::dvec3(1.0);
  if (media_.ior(next) != media_.ior(medium) || s.tinted_reflectance) return std::nullopt;
  return tint_of(s);
}

void Integrator::add_environment(Path& path) const {
  if (!environment_) return;
  const glm::dvec3 radiance = environment_->radiance(path.ray.direction);
  const double weight =
      path.pdf > 0.0 ? share(path.pdf, environment_->pdf(path.ray.direction)) : 1.0;
  path.radiance += path.throughput * radiance * (weight * path.open);
}

// Russian roulette by the power that the path still carries: a path that has lost none of it, as in
// clear glass, goes on, since stopping it would only make others count more. Light that is caught
// in a lossless solid must stop too; from a length that few paths reach, one in fifty ends at each
// bounce.
bool Integrator::survives(Path& path) const {
  constexpr int spared = 4, long_path = 64;
  constexpr double at_most = 0.98;
  ++path.bounces;
  const double power = largest(path.throughput) * path.scale;
  if (path.bounces <= spared) return power > 0.0;
  const double chance = std::min(path.bounces < long_path ? 1.0 : at_most, power);
  if (!(path.random.uniform() < chance)) return false;
  path.throughput /= chance;
  return true;
}

Closure Integrator::closure_at(const Meeting& meeting) const {
  using Face = Meeting::Face;
  const Surface& s = meeting.surface;
  const glm::dvec3 n = meeting.by_triangle ? s.geometric : s.n;
  if (meeting.face == Face::first) {
    // A wall tints what reaches its other side, once.
    const glm::dvec3 tint = meeting.solid() ? tint_of(s) : glm::dvec3(1.0);
    return Closure(interface_of(s, meeting.ior_before, meeting.ior_beyond, settings_.smith, tint),
                   meeting.by_triangle ? face_viewer(n, meeting.wo) : n, meeting.wo);
  }
  Surface clear = s;
  clear.metallic = 0.0;
  clear.transmission = 1.0;
  const bool far = meeting.face == Face::far;
  const glm::dvec3 tint = far ? s.base_color : glm::dvec3(1.0);
  return Closure(interface_of(clear, meeting.ior_beyond, meeting.ior_before, settings_.smith, tint),
                 face_viewer(far ? n : -n, meeting.wo), meeting.wo);
}

bool Integrator::scatter(Path& path, Meeting& m) const {
  using Face = Meeting::Face;
  const bool alone = settings_.transport == Transport::surface_only;
  while (true) {
    const Closure closure = closure_at(m);
    add_direct_light(path, m, closure);
    const std::optional<Drawn> drawn = closure.sample(path.random);
    if (!drawn) return false;
    const bool across = drawn->transmitted;
    const double eta2 = across ? closure.interface().eta * closure.interface().eta : 1.0;

    if (!m.leaves(across)) {
      path.throughput *= drawn->weight;
      path.scale *= eta2;
      m.face = m.face == Face::far ? Face::near : Face::far;
      m.wo = -drawn->wi;
      if (!survives(path)) return false;
      continue;
    }
    if (!alone && !m.right_side(drawn->wi, across)) {
      if (m.by_triangle) return false;
      // The power that was drawn is scattered anew: without the change of radiance across an
      // interface that it does not cross this way.
      path.throughput *= drawn->weight * eta2;
      m.by_triangle = true;
      continue;
    }
    path.throughput *= drawn->weight;
    path.scale *= eta2;
    if (alone && across && m.solid()) path.throughput *= eta2;
    path.inside = m.inside_after(across);
    path.ray = {geometry_.leave(m.surface.hit, drawn->wi), drawn->wi};
    const bool gathered = alone || media_.ior(media_.at(path.inside)) == 1.0;
    path.pdf = gathered ? drawn->pdf : 0.0;
    return survives(path);
  }
}

void Integrator::add_direct_light(Path& path, const Meeting& m, const Closure& closure) const {
  if (closure.only_deltas()) return;
  const bool alone = settings_.transport == Transport::surface_only;

  // f |wi.n| towards a light, times what arrives from there, over what stands in the way.
  struct Link {
    Scattered scattered;
    bool open = false;
    bool across = false;
  };
  const auto link = [&](const glm::dvec3& wi) {
    Link l;
    l.across = glm::dot(wi, closure.n()) < 0.0;
    if (!m.leaves(l.across) || (!alone && !m.right_side(wi, l.across))) return l;
    l.scattered = closure.evaluate(wi);
    if (alone && l.across && m.solid())
      l.scattered.f_cos *= closure.interface().eta * closure.interface().eta;
    l.open = largest(l.scattered.f_cos) > 0.0;
    return l;
  };
  const auto visible = [&](const glm::dvec3& wi, double distance, bool across, bool punctual) {
    if (alone) return glm::dvec3(1.0);
    return shadow({geometry_.leave(m.surface.hit, wi), wi, 0.0, distance}, m.inside_after(across),
                  punctual);
  };

  if (environment_) {
    const auto drawn = environment_->sample(path.random);
    const Link l = drawn ? link(drawn->direction) : Link{};
    // From inside a solid that bends light the environment is seen through its boundary only.
    if (l.open && (alone || media_.ior(media_.at(m.inside_after(l.across))) == 1.0))
      path.radiance += path.throughput * l.scattered.f_cos * drawn->radiance
                       * (share(drawn->pdf, l.scattered.pdf) * path.open / drawn->pdf)
                       * visible(drawn->direction, INFINITY, l.across, false);
  }

  if (scene_.lights.empty()) return;
  // One of the lights, by what arrives from it.
  double total = 0.0;
  for (const scene::Light& light : scene_.lights)
    total += largest(arrival_from(light, m.surface.hit.position).irradiance);
  if (!(total > 0.0)) return;
  double left = path.random.uniform() * total;
  for (const scene::Light& light : scene_.lights) {
    const Arrival arrival = arrival_from(light, m.surface.hit.position);
    const double part = largest(arrival.irradiance);
    left -= part;
    if (left >= 0.0 || !(part > 0.0)) continue;
    if (const Link l = link(arrival.wi); l.open)
      path.radiance += path.throughput * l.scattered.f_cos * arrival.irradiance * (total / part)
                       * visible(arrival.wi, arrival.distance, l.across, true);
    return;
  }
}

// What gets past everything on the ray without changing its direction, per channel.
glm::dvec3 Integrator::shadow(Ray ray, Inside inside, bool through_walls) const {
  if (!casts_clear_shadows_) return glm::dvec3(geometry_.occluded(ray) ? 0.0 : 1.0);
  glm::dvec3 passed(1.0);
  while (const auto hit = geometry_.intersect(ray)) {
    passed *= media_.transmittance(media_.at(inside), hit->distance);
    passed *= straight_through(*hit, ray, inside, through_walls);
    if (!(largest(passed) > 0.0)) return glm::dvec3(0.0);
    const glm::dvec3 next = geometry_.leave(*hit, ray.direction);
    ray.far -= glm::distance(ray.origin, next);
    ray.origin = next;
    if (!(ray.far > 0.0)) return passed;
  }
  return passed
         * (std::isfinite(ray.far) ? media_.transmittance(media_.at(inside), ray.far)
                                   : glm::dvec3(1.0));
}

glm::dvec3 Integrator::straight_through(const Hit& hit, const Ray& ray, Inside& inside,
                                        bool through_walls) const {
  const double coverage = surfaces_.coverage(hit);
  if (coverage == 0.0) return glm::dvec3(1.0);
  const glm::dvec3 beside(1.0 - coverage);
  if (!(hit.part->material->transmission > 0.0f)) return beside;

  const Surface s = surfaces_.read(hit, -ray.direction);
  if (s.kind == SurfaceKind::solid && coverage == 1.0) {
    const SolidId solid = media_.bounded_by(*hit.part), medium = media_.at(inside);
    if (glm::dot(ray.direction, hit.normal) < 0.0)
      inside.enter(solid);
    else
      inside.leave(solid);
    return unbent(s, medium, media_.at(inside)).value_or(glm::dvec3(0.0));
  }
  // A smooth wall: all orders of inner reflection, t² / (1 - r²).
  if (through_walls && s.kind == SurfaceKind::thin && s.alpha == 0.0) {
    Meeting m{.surface = s, .wo = s.wo};
    m.ior_before = media_.ior(media_.at(inside));
    m.ior_beyond = static_cast<double>(s.material->ior);
    const Closure outer = closure_at(m);
    m.surface.metallic = 0.0;
    const Closure::Fresnel f = closure_at(m).fresnel(glm::dot(outer.n(), s.wo));
    const glm::dvec3 kept = glm::dvec3(1.0) - f.reflected * f.reflected;
    glm::dvec3 wall(0.0);
    for (int c = 0; c < 3; ++c)
      if (kept[c] > 0.0) wall[c] = f.entering * f.entering / kept[c];
    return beside + coverage * (1.0 - s.metallic) * s.transmission * s.base_color * wall;
  }
  return beside;
}

} // namespace gg::truth
