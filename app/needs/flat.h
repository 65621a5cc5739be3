// When a thing with three sizes counts as a plane.
#pragma once

namespace gg::needs {

inline constexpr double flat_below =
    1e-4; // of its greater side: thinner than a pixel of most pictures

} // namespace gg::needs
