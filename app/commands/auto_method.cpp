#include "commands/auto_method.h"

#include "commands/subject.h"
#include "core/cache_directory.h"
#include "core/error.h"
#include "report/cache.h"
#include "report/frames.h"
#include "report/report.h"
#include "report/truths.h"
#include "truth/interrupt.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace gg::commands {
namespace {

namespace fs = std::filesystem;

// Where measurements are kept; without a home, as long as the temporary directory lasts.
fs::path measurements() {
  const auto cache = cache_directory();
  return cache ? *cache / "auto" : fs::temp_directory_path() / "groundglass-auto";
}

void check(const MethodOptions& o) {
  if (o.method != "auto") {
    if (o.budget || o.max_error)
      throw Error(ExitCode::usage, o.budget ? "--budget" : "--max-error",
                  "chooses a method, and without --method auto it is " + o.method,
                  "Add --method auto.");
    return;
  }
  if (!o.budget == !o.max_error)
    throw Error(ExitCode::usage, "--method auto", "wants one limit",
                "Give --budget MS or --max-error X (relMSE over the objects).");
  for (const auto& [name, value] :
       {std::pair{"--budget", o.budget}, std::pair{"--max-error", o.max_error}})
    if (value && !(*value > 0.0 && std::isfinite(*value)))
      throw Error(ExitCode::usage, name, "must be more than 0, and finite");
}

// The same picture, no side longer than measured_side.
SceneOptions reduced(const SceneOptions& scene) {
  const Size size = parse_size(scene.size);
  const double scale =
      std::min(1.0, static_cast<double>(measured_side) / std::max(size.width, size.height));
  const auto side = [&](int full) { return std::max(1L, std::lround(scale * full)); };
  SceneOptions result = scene;
  result.size = fmt::format("{}x{}", side(size.width), side(size.height));
  return result;
}

} // namespace

ChosenMethod choose_method(const SceneOptions& scene, const DeviceOptions& device,
                           const MethodOptions& method) {
  check(method);
  if (method.method != "auto") return {find_method(method.method)};
  report::Plan plan{.correlated_smith = method.smith == "correlated",
                    .multiple_scattering = method.multiscatter,
                    .samples = {1},
                    .truth_samples = measured_samples,
                    .limit = {.max_error = method.max_error, .budget = method.budget}};
  for (const NamedMethod& m : methods())
    plan.methods.push_back({m.name, m.method});
  plan.devices.emplace_back(device.backend, [device] { return open_device(device); });

  const truth::Interruptible interruptible;
  const report::Cache cache(measurements());
  report::Devices devices(plan);
  const report::Subject full = subject_of(scene, method.smith, method.multiscatter);
  std::vector<report::Point> all, best; // by relMSE, and by its 1 %-trimmed form
  try {
    std::unique_ptr<report::Loaded> loaded;
    for (const report::Cell& cell :
         report::drawn(full, plan, cache, devices, [&]() -> const report::Loaded& {
           if (!loaded) loaded = full.load();
           return *loaded;
         }).cells)
      all.push_back({.ms = cell.timing.picture.median});
    plan.samples = {4}; // the small picture's edges, antialiased as the truth's are
    plan.pictures = 1;  // its times are not asked for
    report::Work work;
    const report::Section small = report::measure(
        subject_of(reduced(scene), method.smith, method.multiscatter), plan, cache, devices, work);
    best = all;
    for (std::size_t i = 0; i < all.size(); ++i) {
      all[i].error = report::error_of(small.cells[i], report::Measure::all);
      best[i].error = report::error_of(small.cells[i], report::Measure::trimmed);
    }
  } catch (const report::Interrupted&) {
    throw Error(ExitCode::interrupted, "--method auto", "was interrupted while measuring",
                "The same command goes on from there.");
  }
  const auto choice = report::choose(all, best, plan.limit);
  if (!choice) throw Error(ExitCode::internal, "--method auto", "measured nothing");
  const NamedMethod& chosen = methods()[choice->index];
  const std::size_t i = choice->index;
  note(fmt::format(
      "--method auto: {}, {:.3g} ms for a frame of one sample per pixel, relMSE {:.3g} over the "
      "objects (1 %-trimmed: {:.3g}){}",
      chosen.name, all[i].ms, all[i].error, best[i].error,
      choice->met ? "" : "; no method meets the limit, this one comes nearest"));
  return {chosen, choice->met};
}

} // namespace gg::commands
