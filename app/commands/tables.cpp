// groundglass tables: makes the tables in assets/tables again.
#include "commands/commands.h"
#include "core/error.h"
#include "core/progress.h"
#include "tables/gaussian_fit.h"
#include "tables/reflection_table.h"

#include <CLI/CLI.hpp>

#include <filesystem>
#include <memory>

namespace gg::commands {

void add_tables(CLI::App& app) {
  const auto out = std::make_shared<std::string>();
  CLI::App* sub = app.add_subcommand(
      "tables", "Fit the tables of the reflection lobe (assets/tables): minutes");
  sub->add_option("-o,--out", *out, "Directory for the tables, which must exist")->required();
  sub->callback([out] {
    if (!std::filesystem::is_directory(*out))
      throw Error(ExitCode::output, *out, "is not a directory", "Create it first.");
    Progress progress("tables", tables::rows_of_work() * static_cast<long>(tables::models.size()));
    const tables::Training training = tables::make_training(&progress);
    long done = 0;
    for (const tables::Model& model : tables::models) {
      tables::write(*out, tables::make(model, training, &progress, done));
      done += tables::rows_of_work();
    }
  });
}

} // namespace gg::commands
