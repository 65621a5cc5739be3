// Fewer triangles of the same vertices, for pictures so small that nobody sees the difference.
#pragma once

#include "scene/scene.h"

#include <map>
#include <vector>

namespace gg::scene {

struct CoarseList {
  Indices indices;
  float error = 0.0f; // how far its surface is from the whole one, about; in mesh space
};

// By index list, the finest first, each with half of the triangles of the one before at most. Index lists that primitives of
// different vertices share have none.
using CoarseLists = std::map<Index, std::vector<CoarseList>>;

// Edges collapsed by their quadric error (Garland and Heckbert 1997) up to 0.3, 1 and 3 % of the mesh's size. Vertices stay where
// they are, with their normals; borders and seams stay closed.
CoarseLists coarse_lists(const Scene& scene);

} // namespace gg::scene
