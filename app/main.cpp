// groundglass: commands only. Parse, build, run.
#include "commands/command_line.h"
#include "commands/commands.h"
#include "core/error.h"
#include "core/files.h"

#include <cstdio>
#include <new>

int main(int argc, char** argv) {
  using gg::ExitCode;
  gg::clean_up_on_interrupt();

  try {
    gg::commands::CommandLine line(
        "groundglass",
        "Rough glass and rough metal from microfacet theory, in real time, with its error known.",
        GROUNDGLASS_VERSION);
    gg::commands::add_all(line.root());
    line.run(argc, argv); // runs the chosen command's action
    return static_cast<int>(ExitCode::success);
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
