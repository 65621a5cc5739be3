// Which materials bound one body of glass together.
#pragma once

#include "scene/scene.h"

#include <vector>

namespace gg::scene {

// Bounds a volume: light that passes it is inside something.
bool is_solid(const Material& material);

// For each material of the scene the one that stands for its body (itself for most): the parts of an
// instance whose materials have the same stand-in bound one body. Parts of one material do; and
// those of two solid materials if in some mesh the parts of each leave edges open along which they
// meet: a bottle that is clear above and frosted below. The stand-in is the first in the file; the
// volume within is what it says. Positions count as one if they are equal to the bit. Pure.
std::vector<Index> body_materials(const Scene& scene);

} // namespace gg::scene
