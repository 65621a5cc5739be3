// groundglass: commands only. Parse, build, run.
#include "commands/commands.h"
#include "core/error.h"
#include "core/files.h"

#include <CLI/CLI.hpp>

#include <cstdio>
#include <new>

int main(int argc, char** argv) {
  using gg::ExitCode;
  gg::clean_up_on_interrupt();

  CLI::App app(
      "Rough glass and rough metal from microfacet theory, in real time, with its error known.",
      "groundglass");
  app.require_subcommand(1);
  app.set_version_flag("--version", GROUNDGLASS_VERSION);
  gg::commands::add_all(app);

  try {
    // CLI11 would only say that a command is required.
    if (argc > 1 && argv[1][0] != '-'
        && app.get_subcommands([&](const CLI::App* one) { return one->check_name(argv[1]); })
               .empty())
      throw gg::Error(ExitCode::usage, argv[1], "is not a command", "See groundglass --help.");
    app.parse(argc, argv); // runs the chosen command's callback
    return static_cast<int>(ExitCode::success);
  } catch (const CLI::ParseError& error) {
    // CLI11 has codes of its own; ours say 0 for --help and --version, 2 for everything that was
    // mistyped.
    return app.exit(error) == 0 ? 0 : static_cast<int>(ExitCode::usage);
  } catch (const gg::Error& error) {
    std::fprintf(stderr, "groundglass: %s\n", error.what());
    return static_cast<int>(error.code());
  } catch (const std::bad_alloc&) {
    std::fprintf(stderr, "groundglass: out of memory. Try a smaller --size or scene.\n");
    return static_cast<int>(ExitCode::internal);
  } catch (const std::exception& error) {
    std::fprintf(
        stderr,
        "groundglass: internal error: %s. Please report it with the command that led to it.\n",
        error.what());
    return static_cast<int>(ExitCode::internal);
  }
}
