// groundglass tables: makes the tables in assets/tables again, or scores them.
#include "commands/commands.h"
#include "core/error.h"
#include "core/progress.h"
#include "tables/make_tables.h"
#include "tables/proof.h"

#include <cstdio>
#include <memory>

namespace gg::commands {

void add_tables(Command program) {
  struct Options {
    std::string out, only;
    bool prove = false;
  };
  const auto options = std::make_shared<Options>();
  Command command =
      program.subcommand("tables", "Fit the tables of lobes again (assets/tables); takes minutes");
  command.option("-o,--output", &options->out,
                 "The folder for the tables; made if it is not there");
  command.option("--only", &options->only,
                 "Make only the files whose names match this regular expression, as lobes[12]-ggx");
  command.flag(
      "--prove", options->prove,
      "Fit nothing: print how much nearer the tables in assets/tables are to the exact lobes "
      "than standard practice, on environments that no fit has seen");
  command.action([options] {
    if (options->prove) {
      Progress progress("proof", tables::proof_rows());
      std::fputs(tables::proof_table(tables::prove(progress)).c_str(), stdout);
      return;
    }
    if (options->out.empty())
      throw Error(ExitCode::usage, "tables", "needs -o DIRECTORY or --prove",
                  "For instance: groundglass tables -o assets/tables.");
    tables::make_tables(options->out, options->only);
  });
}

} // namespace gg::commands
