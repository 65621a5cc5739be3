// Normals for meshes that come without, or with some of zero length.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace gg::scene {

// One normal per corner, that of its triangle (three floats each), for positions of three floats
// and corners listed three per triangle. A triangle without area gets +Z: it covers no pixel.
std::vector<float> flat_normals(std::span<const float> positions,
                                std::span<const std::uint32_t> indices);

// Replaces each zero normal by the area-weighted mean of its triangles' normals, or +Z if there is
// none.
void mend_zero_normals(std::span<float> normals, std::span<const float> positions,
                       std::span<const std::uint32_t> indices);

} // namespace gg::scene
