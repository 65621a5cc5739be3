// groundglass list: the names that the other commands take.
#include "commands/commands.h"
#include "commands/environment_name.h"
#include "commands/options.h"
#include "scene/presets.h"

#include <fmt/format.h>

namespace gg::commands {
namespace {

struct ListOptions {
  std::string what;
};

std::string description_of(const NamedMethod& method) {
  if (method.name == "standard")
    return "the usual approximation: one interface, one blur by roughness";
  if (method.name.starts_with("fis")) return "importance sampling, prefiltered; fis1 to fis1024";
  const std::string lobes = method.name.substr(std::string_view("lobes").size());
  return lobes + (lobes == "1" ? " Gaussian lobe" : " Gaussian lobes")
         + " fitted to each interface";
}

void print_presets() {
  fmt::print("Presets of materials (--material 'NAME=PRESET'):\n");
  for (const scene::Preset& p : scene::presets()) {
    if (p.kind == scene::PresetKind::conductor)
      fmt::print("  {:<16} metal\n", p.name);
    else if (p.kind == scene::PresetKind::dielectric)
      fmt::print("  {:<16} clear solid, IOR {:.3f}{}\n", p.name, p.ior,
                 p.abbe > 0.0f ? fmt::format(", Abbe number {:.1f}", p.abbe) : "");
    else
      fmt::print("  {:<16} finish, alpha {:g}\n", p.name, p.alpha);
  }
}

void print_environments() {
  fmt::print("Environments (--env NAME; or a file, a colour R,G,B, or none):\n");
  for (const std::string& name : environment_names())
    fmt::print("  {}\n", name);
}

void print_methods() {
  fmt::print("Methods (--method NAME):\n");
  for (const NamedMethod& method : methods())
    fmt::print("  {:<16} {}{}\n", method.name, description_of(method),
               method.name == MethodOptions{}.method ? " (the default)" : "");
  fmt::print("  {:<16} the best of them for a scene, measured: with --budget or --max-error\n",
             "auto");
}

void run(const ListOptions& o) {
  if (o.what.empty() || o.what == "presets") print_presets();
  if (o.what.empty() || o.what == "environments") print_environments();
  if (o.what.empty() || o.what == "methods") print_methods();
}

} // namespace

void add_list(Command program) {
  auto options = std::make_shared<ListOptions>();
  Command command =
      program.subcommand("list", "List material presets, environments and methods by name");
  command.option("WHAT", &options->what, "presets, environments or methods; all if not given")
      .one_of({"presets", "environments", "methods"});
  command.action([options] { run(*options); });
}

} // namespace gg::commands
