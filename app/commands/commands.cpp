#include "commands/commands.h"

namespace gg::commands {

void add_all(CLI::App& app) {
  add_capture(app);
  add_compare(app);
  add_devices(app);
  add_eval(app);
  add_figures(app);
  add_needs(app);
  add_report(app);
  add_tables(app);
  add_truth(app);
  add_unfinished(app);
}

} // namespace gg::commands
