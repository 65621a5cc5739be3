// The materials of a session in a copy of its glTF file.
#pragma once

#include "viewer/view.h"

namespace gg::viewer {

// Writes the file of `view` again, with what --material and the edits say in its materials' "extras" (scene/apply.h), which the
// loader reads back. Files that it refers to are not copied: the copy belongs beside the original, and is written there unless
// `path` has a directory. Throws Error(output), or Error(usage) if the extension is not the original's.
void save_materials(const View& view, const scene::Scene& scene, const std::string& path);

} // namespace gg::viewer
