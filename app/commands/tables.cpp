// groundglass tables: makes the tables in assets/tables again.
#include "commands/commands.h"
#include "core/error.h"
#include "tables/make_tables.h"

#include <CLI/CLI.hpp>

#include <filesystem>
#include <memory>

namespace gg::commands {

void add_tables(CLI::App& app) {
  struct Options {
    std::string out, only;
  };
  const auto options = std::make_shared<Options>();
  CLI::App* sub = app.add_subcommand("tables", "Fit the tables of lobes (assets/tables): minutes");
  sub->add_option("-o,--out", options->out, "Directory for the tables, which must exist")
      ->required();
  sub->add_option(
      "--only", options->only,
      "Make only the files whose names match this regular expression, as lobes[12]-ggx");
  sub->callback([options] {
    if (!std::filesystem::is_directory(options->out))
      throw Error(ExitCode::output, options->out, "is not a directory", "Create it first.");
    tables::make_tables(options->out, options->only);
  });
}

} // namespace gg::commands
