// groundglass snippet: shader snippets for other programs, on standard output.
#include "commands/commands.h"
#include "core/error.h"
#include "core/files.h"
#include "core/suggest.h"
#include "snippet/print.h"

#include <cstdio>
#include <memory>
#include <string>
#include <vector>

namespace gg::commands {

void add_snippet(Command program) {
  struct Options {
    std::vector<std::string> names;
    std::string target = "glsl", explained;
    snippet::PrintOptions print;
    bool listed = false;
  };
  const auto options = std::make_shared<Options>();
  Command command = program.subcommand(
      "snippet", "Print shader snippets with all that they need, in your shading language");
  command.option("NAME", &options->names,
                 "Snippets: ggx, refraction/composition, or a function as ggxD");
  command.option("--target", &options->target,
                 "glsl, vulkan, essl (GLSL ES 3.00), hlsl, msl, wgsl, or cpp: one header over GLM");
  command.option("--prefix", &options->print.prefix,
                 "Put this before every name that the snippets declare");
  command.flag("--strip", options->print.strip, "Leave out comments and empty lines");
  command.flag("--list", options->listed, "Print what there is");
  command.option(
      "--explain", &options->explained,
      "Print signatures, units, ranges, cost, limits and sources of a snippet or function");
  command.action([options] {
    const auto shaders = home_directory() / "shaders";
    const auto target = snippet::target_named(options->target);
    if (!target)
      throw Error(
          ExitCode::usage, "--target " + options->target,
          "is no shading language that snippets are printed in",
          did_you_mean(options->target, std::vector<std::string>{"glsl", "vulkan", "essl", "hlsl",
                                                                 "msl", "wgsl", "cpp"})
              + "Use glsl, vulkan, essl, hlsl, msl, wgsl or cpp.");
    options->print.target = *target;
    if (!options->listed && options->explained.empty() && options->names.empty())
      throw Error(ExitCode::usage, "snippet", "needs a NAME, --list or --explain NAME",
                  "For instance: groundglass snippet ggx --target essl.");
    std::string text;
    if (options->listed) text += snippet::list(shaders);
    if (!options->explained.empty()) text += snippet::explain(shaders, options->explained);
    if (!options->names.empty()) text += snippet::print(shaders, options->names, options->print);
    if (std::fputs(text.c_str(), stdout) < 0 || std::fflush(stdout) != 0)
      throw Error(ExitCode::output, "standard output", "cannot be written");
  });
}

} // namespace gg::commands
