// groundglass tables: makes the tables in assets/tables again, or scores them.
#include "commands/commands.h"
#include "core/error.h"
#include "core/progress.h"
#include "tables/make_tables.h"
#include "tables/proof.h"

#include <cstdio>
#include <filesystem>
#include <memory>

namespace gg::commands {

void add_tables(Command program) {
  struct Options {
    std::string out, only;
    bool prove = false;
  };
  const auto options = std::make_shared<Options>();
  Command command =
      program.subcommand("tables", "Fit the tables of lobes (assets/tables): minutes");
  command.option("-o,--output", &options->out, "Directory for the tables, which must exist");
  command.option("--only", &options->only,
                 "Make only the files whose names match this regular expression, as lobes[12]-ggx");
  command.flag("--prove", options->prove,
               "Make none: score those in assets/tables against standard practice, on environments "
               "that no fit has seen, and print the table");
  command.action([options] {
    if (options->prove) {
      Progress progress("proof", tables::proof_rows());
      std::fputs(tables::proof_table(tables::prove(progress)).c_str(), stdout);
      return;
    }
    if (options->out.empty())
      throw Error(ExitCode::usage, "tables", "needs -o DIRECTORY or --prove",
                  "For instance: groundglass tables -o assets/tables.");
    if (!std::filesystem::is_directory(options->out))
      throw Error(ExitCode::output, options->out, "is not a directory", "Create it first.");
    tables::make_tables(options->out, options->only);
  });
}

} // namespace gg::commands
