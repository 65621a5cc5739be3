#include "commands/commands.h"

namespace gg::commands {

void add_all(Command program) {
  add_capture(program);
  add_compare(program);
  add_convert(program);
  add_devices(program);
  add_eval(program);
  add_figures(program);
  add_list(program);
  add_kit(program);
  add_needs(program);
  add_report(program);
  add_snippet(program);
  add_tables(program);
  add_truth(program);
  add_view(program);
}

} // namespace gg::commands
