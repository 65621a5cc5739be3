#include "viewer/session.h"

#include "scene/apply.h"

namespace gg::viewer {

Edit& edit_of(View& view, scene::Index material) {
  const auto i = static_cast<std::size_t>(material);
  if (view.edits.size() <= i) view.edits.resize(i + 1);
  return view.edits[i];
}

void apply_edits(Session& session) {
  std::vector<scene::Material> before = session.scene->materials;
  session.scene->materials = session.file_materials;
  try {
    // The options that were given are in file_materials already.
    View edits_alone = session.view;
    edits_alone.materials.clear();
    for (const std::string& spec : edits_alone.all_materials())
      scene::apply_material(*session.scene, spec);
  } catch (...) {
    session.scene->materials = std::move(before);
    throw;
  }
}

std::vector<scene::Index> chosen_materials(const Session& session) {
  std::vector<scene::Index> chosen;
  if (!session.scene) return chosen;
  if (session.edit_all)
    for (std::size_t i = 0; i < session.scene->materials.size(); ++i)
      chosen.push_back(static_cast<scene::Index>(i));
  else if (session.picked)
    chosen.push_back(session.picked->material);
  return chosen;
}

} // namespace gg::viewer
