// What a ray passes where it meets triangles: one surface, or several that lie at one place, and the
// solids on both sides.
//
// Walls that two solids share belong to the smaller of them (Media::displaces), as if it reached into
// the larger a little. What bounds no volume lies on the wall: where it is opaque, light ends there.
//
// Alpha on a solid says whether the body is there at all for a ray that comes to it from outside; one
// that it is not there for passes the whole of it. From within alpha is not read.
#pragma once

#include "truth/media.h"
#include "truth/surface.h"

#include <optional>

namespace gg::truth {

// Where a ray is among the solids.
struct Whereabouts {
  Inside inside;
  Inside not_there; // entered where alpha left them out, and passed by until they are left
};

struct Crossing {
  std::optional<Hit> hit; // the surface that is met; nothing: the ray goes on
  Whereabouts before, beyond;
  bool solid = false; // the surface bounds a solid: beyond differs from before
};

// What of a surface with holes a ray meets, where it bounds no volume.
enum class Holes {
  drawn,        // the surface is there by the chance that its coverage says
  by_the_caller // it is met whole, and the caller weighs it by its coverage
};

// Of a ray in this direction that hits there.
Crossing cross(const Hit& hit, const glm::dvec3& direction, const Whereabouts& where,
               const Geometry& geometry, const Media& media, const Surfaces& surfaces,
               Random& random, Holes holes);

} // namespace gg::truth
