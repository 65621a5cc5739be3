#include "commands/subject.h"

#include "environment/stack.h"
#include "needs/needs.h"
#include "needs/words.h"
#include "report/key.h"
#include "scene/origin.h"

#include <fmt/format.h>
#include <glm/trigonometric.hpp>

#include <sstream>

namespace gg::commands {
namespace {

// What `groundglass needs` prints of the method that is drawn if none is asked for, under the command.
std::vector<std::string> needs_of(const report::Loaded& loaded, const std::string& options,
                                  Size size, bool correlated_smith, bool multiscatter) {
  const NamedMethod method = find_method(MethodOptions{}.method);
  needs::View view{.camera = loaded.camera,
                   .width = size.width,
                   .height = size.height,
                   .samples = 1,
                   .method = method.method,
                   .correlated_smith = correlated_smith,
                   .multiple_scattering = multiscatter};
  if (loaded.environment) view.environment = environment::bytes_of(*loaded.environment);
  std::istringstream text(needs::text_of(needs::needs_of(loaded.scene, view)));
  std::vector<std::string> lines{
      fmt::format("groundglass needs {} --samples 1 --method {}", options, method.name), ""};
  for (std::string line; std::getline(text, line);)
    lines.push_back(line);
  return lines;
}

} // namespace

report::Subject subject_of(const SceneOptions& o, const std::string& smith, bool multiscatter) {
  const Size size = parse_size(o.size);
  const auto file = environment_file(o);
  SceneOptions view = o; // what is left of the options when the files are known by their contents
  view.env.clear();
  const std::string key = report::Key()
                              .add(report::key_of_gltf(o.scene))
                              .add(typed_view(view))
                              .add(file ? report::key_of_file(*file) : o.env)
                              .text();
  const std::string options = in_shell(o.scene) + typed_view(o)
                              + (smith == "separable" ? "" : " --smith " + smith)
                              + (multiscatter ? " --multiscatter" : "");
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
                scene::move_origin_to(loaded->camera, loaded->scene);
                loaded->environment = load_environment(o, loaded->scene);
                loaded->rotation = glm::radians(o.env_rotation);
                loaded->intensity = o.env_intensity;
                return loaded;
              },
          .needs =
              [size, smith, multiscatter, options](const report::Loaded& l) {
                return needs_of(l, options, size, smith == "correlated", multiscatter);
              },
          .options = options};
}

} // namespace gg::commands
