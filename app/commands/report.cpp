// groundglass report: how fast and how wrong each method is, for the user's own scenes.
#include "report/report.h"

#include "commands/commands.h"
#include "commands/options.h"
#include "commands/subject.h"
#include "core/error.h"
#include "report/tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <sstream>

namespace gg::commands {
namespace {

namespace fs = std::filesystem;

struct ReportOptions {
  std::vector<std::string> scenes;
  SceneOptions view{.size = "512x512"};
  std::string out, methods, backends = "opengl", surface, smith = "separable";
  std::vector<int> samples = {1, 4, 16};
  int pictures = 20;
  std::optional<int> device;
  long spp = 256;
  std::optional<double> error;
  bool multiscatter = false;
  std::optional<double> max_error, budget;
};

// The parts of "a,b,c", none empty or given twice.
std::vector<std::string> split(const std::string& list, const std::string& option) {
  std::vector<std::string> parts;
  std::istringstream in(list + ",");
  for (std::string part; std::getline(in, part, ',');) {
    if (part.empty() || std::ranges::find(parts, part) != parts.end())
      throw Error(ExitCode::usage, option, "'" + list + "' names nothing or one thing twice",
                  "Write names with commas between them: " + option + " one,other.");
    parts.push_back(part);
  }
  return parts;
}

void check(const ReportOptions& o) {
  const auto between = [](const char* option, long value, long low, long high) {
    if (value < low || value > high)
      throw Error(ExitCode::usage, option, fmt::format("must be from {} to {}", low, high));
  };
  for (std::size_t i = 0; i < o.samples.size(); ++i) {
    between("--samples", o.samples[i], 1, 4096);
    if (std::ranges::find(o.samples.begin(), o.samples.begin() + static_cast<std::ptrdiff_t>(i),
                          o.samples[i])
        != o.samples.begin() + static_cast<std::ptrdiff_t>(i))
      throw Error(ExitCode::usage, "--samples", fmt::format("{} is named twice", o.samples[i]));
  }
  between("--frames", o.pictures, 1, 100'000);
  between("--spp", o.spp, 2, 1L << 30);
  const auto positive = [](const char* option, double value) {
    if (!(value > 0.0) || !std::isfinite(value))
      throw Error(ExitCode::usage, option, "must be more than 0, and finite");
  };
  if (o.error) positive("--error", *o.error);
  if (o.max_error) positive("--max-error", *o.max_error);
  if (o.budget) positive("--budget", *o.budget);
  if (o.smith != "separable" && o.smith != "correlated")
    throw Error(ExitCode::usage, "--smith", "'" + o.smith + "' is not known",
                "Choose separable or correlated.");
}

std::vector<report::Method> methods_of(const ReportOptions& o) {
  std::vector<report::Method> result;
  if (o.methods.empty())
    for (const NamedMethod& m : methods())
      result.push_back({m.name, m.method});
  else
    for (const std::string& name : split(o.methods, "--methods")) {
      const NamedMethod m = find_method(name, "--methods");
      result.push_back({m.name, m.method});
    }
  return result;
}

report::Plan plan_of(const ReportOptions& o) {
  report::Plan plan{.methods = methods_of(o),
                    .correlated_smith = o.smith == "correlated",
                    .multiple_scattering = o.multiscatter,
                    .samples = o.samples,
                    .pictures = o.pictures,
                    .truth_samples = o.spp,
                    .truth_error = o.error.value_or(0.0),
                    .limit = {.max_error = o.max_error, .budget = o.budget},
                    .directory = o.out,
                    .version = GROUNDGLASS_VERSION,
                    .command = command_line()};
  for (const std::string& backend : split(o.backends, "--backend")) {
    const DeviceOptions device{
        .backend = backend, .surface = backend == "vulkan" ? "" : o.surface, .device = o.device};
    device_of(device); // before hours of work, not after
    plan.devices.emplace_back(backend, [device] { return open_device(device); });
  }
  for (const std::string& scene : o.scenes) {
    SceneOptions one = o.view;
    one.scene = scene;
    plan.subjects.push_back(subject_of(one, o.smith, o.multiscatter));
    // Scenes of one name in different folders are told apart by a number.
    const std::string name = plan.subjects.back().name;
    const auto same = std::ranges::count(
        plan.subjects, fs::path(scene).stem().string(),
        [](const report::Subject& s) { return fs::path(s.path).stem().string(); });
    if (same > 1) plan.subjects.back().name = fmt::format("{}-{}", name, same);
  }
  return plan;
}

void run(const ReportOptions& o) {
  check(o);
  const report::Plan plan = plan_of(o);
  const report::Outcome outcome = report::run(plan);
  bool unmet = false;
  for (const report::Section& section : outcome.report.sections) {
    if (!section.choice) continue;
    fmt::print("{}: {}\n", section.name, report::choice_text(section, plan.limit));
    unmet = unmet || !section.choice->met;
  }
  const report::Work& work = outcome.work;
  if (!outcome.report.sections.empty()) // else there is no page
    fmt::print(
        "{}: {} of {} scenes; in this run truths traced: {}, pictures drawn: {}, timed: {}\n",
        (plan.directory / "report.html").string(), outcome.report.sections.size(),
        plan.subjects.size(), work.traced, work.drawn, work.timed);
  if (outcome.interrupted)
    throw Error(ExitCode::interrupted, o.out,
                fmt::format("interrupted; {} of {} scenes are in the report",
                            outcome.report.sections.size(), plan.subjects.size()),
                "The same command goes on from there.");
  if (unmet)
    throw Error(ExitCode::different, o.max_error ? "--max-error" : "--budget",
                "is met by no method in at least one scene", "The report names the nearest one.");
}

} // namespace

void add_report(Command program) {
  auto o = std::make_shared<ReportOptions>();
  Command command = program.subcommand(
      "report", "Measure how fast and how wrong each method is, and write a page about it");
  command.option("SCENE", &o->scenes, "glTF 2.0 files").required();
  command.option("-o,--output", &o->out, "The folder for the page, its data and its cache")
      .required();
  command.option(
      "--methods", &o->methods,
      "Names that `groundglass list methods` prints, with commas between them (all if not given)");
  command.option("--backend", &o->backends, "opengl, vulkan, or both: opengl,vulkan");
  command.option("--surface", &o->surface, "egl or osmesa (OpenGL only)");
  command.option("--device", &o->device, "Index from `groundglass devices`");
  add_view_options(command, o->view);
  command
      .option("--samples", &o->samples,
              "Samples per pixel of the pictures, with commas between them: a point for each "
              "(1,4,16 if not given)")
      .comma_separated();
  command.option("--frames", &o->pictures,
                 "How often each picture is timed; slow scenes stop at 5");
  const Option spp = command.option("--spp", &o->spp, "Samples per pixel of the truth");
  command
      .option("--error", &o->error,
              "In place of --spp: trace until the truth's relative error is this small (see truth "
              "--help)")
      .excludes(spp);
  command.option("--smith", &o->smith, "Shadowing: separable (Walter 2007) or correlated");
  command.flag("--multiscatter", o->multiscatter,
               "Give back the energy of multiple scattering, in the truth too");
  const Option budget =
      command.option("--budget", &o->budget,
                     "Name the most accurate method within so many ms for a picture (1 %-trimmed "
                     "relMSE over the objects); exit 7 if none is");
  command
      .option(
          "--max-error", &o->max_error,
          "Name the fastest method whose relMSE over the objects is no larger; exit 7 if none is")
      .excludes(budget);
  command.action([o] { run(*o); });
}

} // namespace gg::commands
