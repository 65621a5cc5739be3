// The shape of a solid, as far as it decides how rays inside it are followed.
#pragma once

#include "scene/scene.h"

#include <span>

namespace gg::scene {

struct SolidShape {
  // No edge is open: with vertices at one place taken as one (see weld.h), the triangles pass every
  // edge as often one way as the other. What is not closed has no inside.
  bool closed = false;
  // Closed, in one piece, and no edge turns inwards: a line of sight meets one front and one back
  // face at most.
  bool convex = false;
  // The normals are those of the triangles: faces are planes.
  bool flat = false;
  // All of it lies in one plane, to a hundred-thousandth of its size: what rounding to 16 bits leaves.
  bool planar = false;
};

// Of all triangles of `parts` together, which must be of one mesh: the parts of an instance that
// share a material bound one solid. Triangles that have no area at all do not count. No triangles:
// nothing of the above. Coordinates may be rounded to 14 bits of the size (weld.h: coarsest_quantum):
// a dent no deeper than that explains is none.
SolidShape solid_shape(const Scene& scene, std::span<const Primitive* const> parts);

} // namespace gg::scene
