// The program of which app/demo draws the first picture: capture, by a method that is named. It links half of the libraries, so the
// picture is there long before all is built.
#include "commands/commands.h"
#include "core/error.h"

namespace gg::commands {

void add_all(Command program) {
  add_capture(program, [](const SceneOptions&, const DeviceOptions&, const MethodOptions& method) {
    if (method.method == "auto" || method.budget || method.max_error)
      throw Error(ExitCode::unsupported, "--method auto", "measures, which this program cannot",
                  "Build all of groundglass (cmake --build build) and use that.");
    return ChosenMethod{find_method(method.method)};
  });
}

} // namespace gg::commands
