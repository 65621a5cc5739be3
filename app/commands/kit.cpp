// groundglass kit: a folder with which rough refraction runs in another program.
#include "kit/kit.h"

#include "commands/commands.h"
#include "core/error.h"
#include "core/files.h"
#include "core/suggest.h"

#include <cstdio>
#include <memory>
#include <string>

namespace gg::commands {

void add_kit(Command program) {
  struct Options {
    std::string target, out;
  };
  const auto options = std::make_shared<Options>();
  Command command =
      program.subcommand("kit", "Write a folder with which rough glass runs in another program");
  command
      .option(
          "--target", &options->target,
          "three (three.js, WebGLRenderer), webgl2 (one page, no library), opengl or vulkan (one "
          "C++ file)")
      .required();
  command.option("-o,--output", &options->out, "The folder; made if it is not there").required();
  command.action([options] {
    const auto target = kit::target_named(options->target);
    if (!target)
      throw Error(ExitCode::usage, "--target " + options->target,
                  "is nothing that a kit is made for",
                  did_you_mean(options->target, kit::target_names())
                      + "Use three, webgl2, opengl or vulkan.");
    kit::write(*target, home_directory(), options->out);
    std::printf("%s: see README.md there\n", options->out.c_str());
  });
}

} // namespace gg::commands
