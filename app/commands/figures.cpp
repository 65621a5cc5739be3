// groundglass figures: the lecture's figures, redrawn.
#include "figures/figures.h"

#include "commands/commands.h"

#include <fmt/core.h>

#include <memory>

namespace gg::commands {

void add_figures(Command program) {
  Command command = program.subcommand(
      "figures", "Draw Fresnel reflectance, D, G and the lobes of rough glass (SVG and PNG)");
  const auto directory = std::make_shared<std::filesystem::path>();
  command
      .option("-o,--output", directory.get(),
              "Directory for the figures, made if it does not exist")
      .required();
  command.action([directory] {
    for (const std::string& name : figures::write_all(*directory))
      fmt::print("{}\n", (*directory / name).string());
  });
}

} // namespace gg::commands
