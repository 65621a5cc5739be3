// Hollows kept between runs: half a second of rays for a scene that has some.
#pragma once

#include "needs/hollows.h"

namespace gg::needs {

// hollows_of(), read from the cache directory if an earlier run of this build of the program has kept them there.
Hollows hollows_kept_or_of(const scene::Scene& scene, const Proxies& proxies);

} // namespace gg::needs
