// Which materials bound one body of glass together.
#pragma once

#include "scene/scene.h"

#include <map>
#include <utility>
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

// Which solids have an inside. An open sheet with a thickness has none: it is a plate of that
// thickness. Closed meshes have one, and so have those that nearly are (scene/bodies.cpp): seams and
// small holes do not count. `scene` must outlive it.
class Bodies {
public:
  explicit Bodies(const Scene& scene) : scene_(scene), stands_in_(body_materials(scene)) {}
  // Of the material's body in the mesh; false if the material is no solid's.
  bool has_inside(Index mesh, Index material);

private:
  const Scene& scene_;
  std::vector<Index> stands_in_;
  std::map<std::pair<Index, Index>, bool> known_;
};

} // namespace gg::scene
