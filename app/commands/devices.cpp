// groundglass devices: what --device N chooses from.
#include "commands/commands.h"
#include "commands/json_file.h"
#include "core/error.h"
#include "gpu/device.h"

#include <fmt/core.h>
#include <nlohmann/json.hpp>

namespace gg::commands {
namespace {

void print(const std::string& json_file) {
  const auto devices = gpu::list_devices();
  if (devices.empty())
    throw Error(ExitCode::device, "groundglass", "no device found",
                "Install Mesa's drivers: libegl1 and libgl1-mesa-dri.");
  if (!json_file.empty()) {
    nlohmann::json list = nlohmann::json::array();
    for (const auto& d : devices)
      list.push_back({{"backend", d.backend},
                      {"surface", d.surface},
                      {"device", d.index},
                      {"software", d.software},
                      {"name", d.name},
                      {"driver", d.driver}});
    write_json(json_file, {{"devices", list}});
    if (json_file == "-") return;
  }
  fmt::print("{:<8} {:<8} {:<3} {:<8} {}\n", "backend", "surface", "N", "kind", "name (driver)");
  for (const auto& d : devices)
    fmt::print("{:<8} {:<8} {:<3} {:<8} {} ({})\n", d.backend, d.surface, d.index,
               d.software ? "software" : "hardware", d.name, d.driver);
}

} // namespace

void add_devices(Command program) {
  const auto json_file = std::make_shared<std::string>();
  Command command = program.subcommand(
      "devices", "List the devices that can draw, for --backend, --surface and --device");
  command.option("--json", json_file.get(),
                 "Write the list to this file, or to standard output: -");
  command.action([json_file] { print(*json_file); });
}

} // namespace gg::commands
