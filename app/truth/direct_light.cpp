// What reaches a surface from lights straight away.
#include "truth/integrator.h"
#include "truth/lights.h"
#include "truth/mis.h"
#include "truth/walk.h"

#include <array>
#include <cmath>

namespace gg::truth {

void Integrator::add_direct_light(Walk& walk, Path path, const Intersection& m,
                                  const Closure& closure) const {
  if (closure.only_deltas()) return;
  path.scattered = true; // here
  const bool alone = settings_.transport == Transport::surface_only;

  // From inside a solid that bends light the environment is seen through its boundary only.
  std::array<bool, 2> seen{};
  for (const bool across : {false, true})
    seen[across] =
        alone || media_.ior(media_.at(m.where_after(across).inside), path.channel) == 1.0;

  // f |wi.n| towards a light, times what arrives from there, over what stands in the way.
  struct Link {
    Scattered scattered;
    bool open = false;
    bool across = false;
  };
  const auto link = [&](const glm::dvec3& wi, bool infinite) {
    Link l;
    l.across = glm::dot(wi, closure.n()) < 0.0;
    if (!m.leaves(l.across) || (!alone && !m.right_side(wi, l.across))) return l;
    if (infinite && !seen[l.across]) return l;
    l.scattered = closure.evaluate(wi);
    if (alone && l.across && m.solid())
      l.scattered.f_cos *= closure.interface().eta * closure.interface().eta;
    l.open = largest(l.scattered.f_cos) > 0.0;
    return l;
  };
  const auto visible = [&](const glm::dvec3& wi, double distance, bool across, bool punctual) {
    if (alone) return glm::dvec3(1.0);
    return shadow({geometry_.leave(m.surface.hit, wi), wi, 0.0, distance}, m.surface.hit.position,
                  m.where_after(across), path.channel, punctual, walk.random);
  };

  if (environment_ && (seen[0] || seen[1])) {
    // Of several directions, one by what would arrive from it [TalbotCE05]: the environment is looked
    // up often and a shadow ray is sent once.
    struct Candidate {
      glm::dvec3 wi{0.0}, arrives{0.0};
      bool across = false;
    };
    std::array<Candidate, environment_candidates> candidates;
    std::array<double, environment_candidates> sums{};
    double sum = 0.0;
    for (int k = 0; k < environment_candidates; ++k) {
      const auto drawn = environment_->sample(walk.random, k, environment_candidates);
      const Link l = drawn ? link(drawn->direction, true) : Link{};
      if (l.open) {
        const double density = environment_candidates * drawn->pdf;
        candidates[static_cast<std::size_t>(k)] = {
            drawn->direction,
            path.throughput * l.scattered.f_cos * environment_->radiance(drawn->place)
                * (mis_share(density, l.scattered.pdf) * path.open / density),
            l.across};
        sum += largest(candidates[static_cast<std::size_t>(k)].arrives);
      }
      sums[static_cast<std::size_t>(k)] = sum;
    }
    // What is small beside the environment is looked for as seldom as it is small.
    const double worth = environment_->mean_radiance() / 32.0;
    const double chance = std::min(sum / worth, 1.0);
    if (sum > 0.0 && (chance == 1.0 || walk.random.uniform() < chance)) {
      const double u = walk.random.uniform() * sum;
      std::size_t chosen = 0;
      while (chosen + 1 < candidates.size() && sums[chosen] <= u)
        ++chosen;
      const Candidate& c = candidates[chosen];
      const double one = largest(c.arrives);
      if (one > 0.0)
        add(walk, path,
            c.arrives * (sum / (one * chance)) * visible(c.wi, INFINITY, c.across, false));
    }
  }

  if (scene_.lights.empty()) return;
  // One of the lights, by what arrives from it.
  double total = 0.0;
  for (const scene::Light& light : scene_.lights)
    total += largest(arrival_from(light, m.surface.hit.position).irradiance);
  if (!(total > 0.0)) return;
  double left = walk.random.uniform() * total;
  for (const scene::Light& light : scene_.lights) {
    const Arrival arrival = arrival_from(light, m.surface.hit.position);
    const double part = largest(arrival.irradiance);
    left -= part;
    if (left >= 0.0 || !(part > 0.0)) continue;
    if (const Link l = link(arrival.wi, false); l.open)
      add(walk, path,
          path.throughput * l.scattered.f_cos * arrival.irradiance * (total / part)
              * visible(arrival.wi, arrival.distance, l.across, true));
    return;
  }
}

// What gets past everything on the ray without changing its direction, per channel. `from`: the
// surface that it starts a rounding off.
glm::dvec3 Integrator::shadow(Ray ray, glm::dvec3 from, Whereabouts where, int channel,
                              bool through_walls, Random& random) const {
  // A ray that comes from air to a solid ends there if the solid bends light, whatever comes behind.
  const bool passes = through_walls ? passes_to_lights_ : passes_straight_;
  if (!passes && where.inside.empty() && where.not_there.empty())
    return glm::dvec3(geometry_.occluded(ray) ? 0.0 : 1.0);
  const glm::dvec3 end = ray.origin + ray.far * ray.direction; // where it is finite
  glm::dvec3 passed(1.0);
  while (const auto hit = geometry_.intersect(ray)) {
    const Crossing crossing = cross(*hit, ray.direction, where, geometry_, media_, surfaces_,
                                    random, Holes::by_the_caller);
    passed *=
        media_.transmittance(media_.at(crossing.before.inside), glm::distance(from, hit->position));
    from = hit->position;
    where = crossing.beyond;
    if (crossing.hit) passed *= straight_through(crossing, ray, channel, through_walls);
    if (!(largest(passed) > 0.0)) return glm::dvec3(0.0);
    const glm::dvec3 next = geometry_.leave(*hit, ray.direction);
    ray.far -= glm::distance(ray.origin, next);
    ray.origin = next;
    if (!(ray.far > 0.0)) return passed;
  }
  if (!std::isfinite(ray.far)) return passed;
  return passed * media_.transmittance(media_.at(where.inside), glm::distance(from, end));
}

glm::dvec3 Integrator::straight_through(const Crossing& crossing, const Ray& ray, int channel,
                                        bool through_walls) const {
  const Hit& hit = *crossing.hit;
  const double coverage = hit.part->solid ? 1.0 : surfaces_.coverage(hit);
  const glm::dvec3 beside(1.0 - coverage);
  if (!(hit.part->material->transmission > 0.0f && coverage > 0.0)) return beside;
  const Surface s = surfaces_.read(hit, -ray.direction);
  const SolidId medium = media_.at(crossing.before.inside);
  if (s.kind == SurfaceKind::solid)
    return unbent(s, medium, media_.at(crossing.beyond.inside), channel).value_or(glm::dvec3(0.0));
  // A smooth wall: all orders of inner reflection, t² / (1 - r²). A plate moves light aside.
  if (through_walls && s.kind == SurfaceKind::thin && s.alpha == 0.0 && s.thickness == 0.0) {
    Intersection m{.surface = s, .wo = s.wo};
    m.ior_before = media_.ior(medium, channel);
    m.ior_beyond = static_cast<double>(s.material->ior);
    const Closure outer = closure_at(m, {});
    const double under =
        s.coat ? 1.0 - glsl::f64::coatShare(s.coat->strength, glm::dot(s.coat->n, s.wo)) : 1.0;
    const glm::dvec3 first = outer.fresnel(glm::dot(outer.n(), s.wo)).refracted;
    m.surface.metallic = 0.0;
    m.surface.film.reset();
    const Closure::Fresnel f = closure_at(m, {}).fresnel(glm::dot(outer.n(), s.wo));
    const glm::dvec3 kept = glm::dvec3(1.0) - f.reflected * f.reflected;
    glm::dvec3 wall(0.0);
    for (int c = 0; c < 3; ++c)
      if (kept[c] > 0.0) wall[c] = under * first[c] * f.entering / kept[c];
    return beside + coverage * (1.0 - s.metallic) * s.transmission * s.base_color * wall;
  }
  return beside;
}

} // namespace gg::truth
