// Fewer triangles of the same vertices, for pictures so small that nobody sees the difference.
#pragma once

#include "scene/scene.h"

#include <map>

namespace gg::scene {

struct CoarseList {
  Indices indices;
  float error = 0.0f; // how far its surface is from the whole one, about; in mesh space
};

// By index list. Lists that would keep more than half of their triangles are not there, nor are those that primitives of different
// vertices share.
using CoarseLists = std::map<Index, CoarseList>;

// Edges collapsed by their quadric error (Garland and Heckbert 1997) up to 0.3 % of the mesh's size. Vertices stay where they
// are, with their normals; borders and seams stay closed.
CoarseLists coarse_lists(const Scene& scene);

} // namespace gg::scene
