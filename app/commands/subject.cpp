#include "commands/subject.h"

#include "report/key.h"

#include <glm/trigonometric.hpp>

namespace gg::commands {

report::Subject subject_of(const SceneOptions& o, const std::string& smith) {
  const Size size = parse_size(o.size);
  const auto file = environment_file(o);
  SceneOptions view = o; // what is left of the options when the files are known by their contents
  view.env.clear();
  const std::string key = report::Key()
                              .add(report::key_of_gltf(o.scene))
                              .add(typed_view(view))
                              .add(file ? report::key_of_file(*file) : o.env)
                              .text();
  return {.name = std::filesystem::path(o.scene).stem().string(),
          .path = o.scene,
          .environment = file ? file->filename().string() : o.env,
          .key = key,
          .width = size.width,
          .height = size.height,
          .load =
              [o, size] {
                auto loaded = std::make_unique<report::Loaded>();
                loaded->scene = load_scene(o);
                loaded->camera = choose_camera(o, loaded->scene, size);
                loaded->environment = load_environment(o, loaded->scene);
                loaded->rotation = glm::radians(o.env_rotation);
                loaded->intensity = o.env_intensity;
                return loaded;
              },
          .needs = {},
          .options = in_shell(o.scene) + typed_view(o)
                     + (smith == "separable" ? "" : " --smith " + smith)};
}

} // namespace gg::commands
