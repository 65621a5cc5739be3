// Commands whose names are promised and whose work has not landed. They say so and fail, so that a
// script notices.
#include "commands/commands.h"
#include "core/error.h"

#include <CLI/CLI.hpp>

#include <string>

namespace gg::commands {

void add_unfinished(CLI::App& app) {
  struct Unfinished {
    const char *name, *description, *instead;
  };
  for (const Unfinished& command : {
           Unfinished{"view", "Interactive viewer", "Use capture for a picture."},
           Unfinished{"snippet", "Print a shader snippet, flattened",
                      "The files are in shaders/; see shaders/README.md."},
       }) {
    CLI::App* sub =
        app.add_subcommand(command.name, std::string(command.description) + " (not yet available)");
    sub->allow_extras();
    sub->callback([command] {
      throw Error(ExitCode::unsupported, std::string("groundglass ") + command.name,
                  "is not available yet", command.instead);
    });
  }
}

} // namespace gg::commands
