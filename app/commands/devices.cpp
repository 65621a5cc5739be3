// groundglass devices: what --device N chooses from.
#include "commands/commands.h"
#include "core/error.h"
#include "gpu/device.h"

#include <fmt/core.h>

namespace gg::commands {
namespace {

void print() {
  const auto devices = gpu::list_devices();
  if (devices.empty())
    throw Error(ExitCode::device, "groundglass", "no device found",
                "Install Mesa's drivers: libegl1 and libgl1-mesa-dri.");
  fmt::print("{:<8} {:<8} {:<3} {:<8} {}\n", "backend", "surface", "N", "kind", "name (driver)");
  for (const auto& d : devices)
    fmt::print("{:<8} {:<8} {:<3} {:<8} {} ({})\n", d.backend, d.surface, d.index,
               d.software ? "software" : "hardware", d.name, d.driver);
}

} // namespace

void add_devices(Command program) {
  Command command = program.subcommand(
      "devices", "List the devices that can draw, for --backend, --surface and --device");
  command.action(print);
}

} // namespace gg::commands
