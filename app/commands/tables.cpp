// groundglass tables: makes the tables in assets/tables again, or scores them.
#include "commands/commands.h"
#include "core/error.h"
#include "core/progress.h"
#include "tables/make_tables.h"
#include "tables/proof.h"

#include <CLI/CLI.hpp>

#include <cstdio>
#include <filesystem>
#include <memory>

namespace gg::commands {

void add_tables(CLI::App& app) {
  struct Options {
    std::string out, only;
    bool prove = false;
  };
  const auto options = std::make_shared<Options>();
  CLI::App* sub = app.add_subcommand("tables", "Fit the tables of lobes (assets/tables): minutes");
  sub->add_option("-o,--out", options->out, "Directory for the tables, which must exist");
  sub->add_option(
      "--only", options->only,
      "Make only the files whose names match this regular expression, as lobes[12]-ggx");
  sub->add_flag(
      "--prove", options->prove,
      "Make none: score those in assets/tables against standard practice, on environments "
      "that no fit has seen, and print the table");
  sub->callback([options] {
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
