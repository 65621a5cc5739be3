// groundglass needs: what drawing a scene takes, without drawing it.
#include "needs/needs.h"

#include "commands/commands.h"
#include "commands/json_file.h"
#include "commands/options.h"
#include "core/error.h"
#include "environment/stack.h"
#include "frame/words.h"
#include "needs/left_out.h"
#include "needs/words.h"

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include <memory>

namespace gg::commands {
namespace {

struct NeedsOptions {
  SceneOptions scene;
  MethodOptions method;
  std::string json;
};

void print(const NeedsOptions& o) {
  probe_outputs({o.json});
  if (o.method.samples < 1 || o.method.samples > 4096)
    throw Error(ExitCode::usage, "--samples", "must be from 1 to 4096");
  if (o.method.smith != "separable" && o.method.smith != "correlated")
    throw Error(ExitCode::usage, "--smith", "'" + o.method.smith + "' is not known",
                "Choose separable or correlated.");
  const Size size = parse_size(o.scene.size);
  const needs::Method method = parse_method(o.method.method);
  const scene::Scene scene = load_scene(o.scene);
  needs::View view{.camera = choose_camera(o.scene, scene, size),
                   .width = size.width,
                   .height = size.height,
                   .samples = o.method.samples,
                   .method = method,
                   .correlated_smith = o.method.smith == "correlated",
                   .multiple_scattering = o.method.multiscatter,
                   .environment = {},
                   .without = needs::left_out(o.method.without)};
  if (const auto map = load_environment(o.scene, scene))
    view.environment = environment::bytes_of(*map);
  const needs::Needs needs = needs::needs_of(scene, view);
  const frame::Graph graph = frame::graph_of(needs);
  fmt::print(text_stream({o.json}), "{}: {}x{}, {} samples, {}\n{}\n{}", o.scene.scene, size.width,
             size.height, o.method.samples, o.method.method, needs::text_of(needs),
             frame::text_of(needs, graph));
  if (o.json.empty()) return;
  nlohmann::json report = needs::json_of(needs);
  report.update(frame::json_of(needs, graph));
  report["scene"] = o.scene.scene;
  report["method"] = o.method.method;
  write_json(o.json, report);
}

} // namespace

void add_needs(Command program) {
  auto options = std::make_shared<NeedsOptions>();
  Command command = program.subcommand(
      "needs", "Print what drawing a scene takes: passes, features, tables, targets, bytes");
  add_options(command, options->scene);
  add_options(command, options->method);
  command.option("--json", &options->json,
                 "Write the same as JSON to this file, or to standard output: -");
  command.action([options] { print(*options); });
}

} // namespace gg::commands
