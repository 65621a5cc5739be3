#include "truth/crossing.h"

#include <algorithm>

namespace gg::truth {
namespace {

bool is_there(const Hit& hit, const Surfaces& surfaces, Random& random) {
  return !Surfaces::has_holes(*hit.part->material) || random.uniform() < surfaces.coverage(hit);
}

bool is_opaque(const Part& part) {
  return part.material->unlit || !(part.material->transmission > 0.0f);
}

} // namespace

Crossing cross(const Hit& first, const glm::dvec3& direction, const Whereabouts& where,
               const Geometry& geometry, const Media& media, const Surfaces& surfaces,
               Random& random, Holes holes) {
  Crossing c{.hit = std::nullopt, .before = where, .beyond = where};
  SolidId owner = air;
  const bool whole = holes == Holes::by_the_caller;
  const auto pass = [&](const Hit& hit) {
    const SolidId solid = media.bounded_by(*hit.part);
    const bool enters = glm::dot(direction, hit.normal) < 0.0;
    if (c.beyond.not_there.contains(solid)) {
      if (enters)
        c.beyond.not_there.enter(solid);
      else
        c.beyond.not_there.leave(solid);
      return;
    }
    if (enters && !is_there(hit, surfaces, random)) {
      c.beyond.not_there.enter(solid);
      return;
    }
    if (enters) {
      c.beyond.inside.enter(solid);
    } else {
      // A solid that is left was entered somewhere, if only through a hole in its mesh.
      if (!c.before.inside.contains(solid)) c.before.inside.enter(solid);
      c.beyond.inside.leave(solid);
    }
    if (owner == air || media.displaces(solid, owner)) {
      owner = solid;
      c.hit = hit;
    }
  };

  const std::vector<Hit> others = geometry.touching(first, direction);
  if (others.empty() || !(first.part->solid || std::ranges::any_of(others, [](const Hit& h) {
                            return h.part->solid;
                          }))) {
    // The usual case: one surface, or several of which none bounds a volume.
    if (first.part->solid) {
      pass(first);
    } else if (whole || is_there(first, surfaces, random)) {
      c.hit = first;
    }
    c.solid = owner != air;
    return c;
  }
  const auto covers = [&](const Hit& hit) {
    return !hit.part->solid && is_opaque(*hit.part) && (whole || is_there(hit, surfaces, random));
  };
  if (covers(first)) {
    c.hit = first;
    return c;
  }
  if (const auto found = std::ranges::find_if(others, covers); found != others.end()) {
    c.hit = *found;
    return c;
  }
  std::vector<SolidId> passed;
  const auto pass_once = [&](const Hit& hit) {
    const SolidId solid = media.bounded_by(*hit.part);
    if (solid == air || std::ranges::find(passed, solid) != passed.end()) return;
    passed.push_back(solid);
    pass(hit);
  };
  pass_once(first);
  for (const Hit& other : others)
    pass_once(other);
  c.solid = owner != air;
  return c;
}

} // namespace gg::truth
