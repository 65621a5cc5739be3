// groundglass devices: what --device N chooses from.
#include "commands/commands.h"
#include "core/error.h"
#include "gpu/device.h"

#include <CLI/CLI.hpp>
#include <fmt/core.h>

namespace gg::commands {

void add_devices(CLI::App& app) {
  app.add_subcommand("devices",
                     "List the devices that can draw, for --backend, --surface and --device")
      ->callback([] {
        const auto devices = gpu::list_devices();
        if (devices.empty())
          throw Error(ExitCode::device, "groundglass", "no device found",
                      "Install Mesa's drivers: libegl1 and libgl1-mesa-dri.");
        fmt::print("{:<8} {:<8} {:<3} {:<8} {}\n", "backend", "surface", "N", "kind",
                   "name (driver)");
        for (const auto& d : devices)
          fmt::print("{:<8} {:<8} {:<3} {:<8} {} ({})\n", d.backend, d.surface, d.index,
                     d.software ? "software" : "hardware", d.name, d.driver);
      });
}

} // namespace gg::commands
