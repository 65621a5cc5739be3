#include "commands/commands.h"

#include "commands/auto_method.h"

namespace gg::commands {

void add_all(Command program) {
  add_capture(program, choose_method);
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
