// Commands whose names are promised and whose work has not landed. They say so and fail, so that a
// script notices.
#include "commands/commands.h"
#include "core/error.h"

#include <string>

namespace gg::commands {

void add_unfinished(Command program) {
  struct Unfinished {
    const char *name, *description, *instead;
  };
  for (const Unfinished& one : {
           Unfinished{"view", "Interactive viewer", "Use capture for a picture."},
       }) {
    Command command =
        program.subcommand(one.name, std::string(one.description) + " (not yet available)");
    const auto ignored = std::make_shared<std::vector<std::string>>();
    command.option("WORDS", ignored.get(), "What it will take");
    command.action([one, ignored] {
      throw Error(ExitCode::unsupported, std::string("groundglass ") + one.name,
                  "is not available yet", one.instead);
    });
  }
}

} // namespace gg::commands
