// Tangents for what is brushed by a setting, not by its file.
#pragma once

#include "scene/scene.h"

namespace gg::scene {

// Gives the primitives of brushed materials (anisotropy_strength > 0) that have no tangents those of their texture coordinates
// (tangents.h), as the loader does where a file asks for brushing. A primitive without coordinates is left as it is, with a note:
// it is drawn without brushing.
void complete_brushing(Scene& scene);

} // namespace gg::scene
