#include "report/report.h"

#include "core/files.h"
#include "core/progress.h"
#include "frame/display.h"
#include "report/exports.h"
#include "report/frames.h"
#include "report/key.h"
#include "report/page.h"
#include "report/plot.h"
#include "report/truths.h"
#include "report/verdict.h"
#include "report/webp.h"
#include "truth/interrupt.h"

#include <fmt/format.h>

#include <algorithm>

namespace gg::report {
namespace {

// Clamped and encoded for a display, as FLIP and PSNR see it.
std::vector<std::byte> shown(const image::Image& radiance) {
  return webp_of(frame::for_display(radiance, 0.0f, frame::ToneMap::none));
}

// A picture for the page, made once.
std::string embedded(const Cache& cache, const std::string& kind, const std::string& key,
                     const std::function<std::vector<std::byte>()>& make) {
  if (const auto bytes = cache.bytes(kind, key, "webp")) return data_uri(*bytes);
  const std::vector<std::byte> bytes = make();
  cache.store(kind, key, "webp", bytes);
  return data_uri(bytes);
}

// Loads a scene, the kinds of its objects and its truth at the first use.
class Shelf {
public:
  explicit Shelf(const Subject& subject) : subject_(subject) {}

  const Loaded& scene() {
    if (!scene_) {
      Progress progress(subject_.name + ": loading", 0);
      progress.update(0);
      scene_ = subject_.load();
    }
    return *scene_;
  }
  const image::Picture& truth(const std::filesystem::path& file) {
    if (!truth_) truth_ = image::load_picture(file);
    return *truth_;
  }

private:
  const Subject& subject_;
  std::unique_ptr<Loaded> scene_;
  std::optional<image::Picture> truth_;
};

// What the page says of a scene beside its measurements.
struct About {
  std::size_t objects = 0;
  std::vector<std::string> needs;
};

About about(const Subject& subject, const Cache& cache, Shelf& shelf) {
  const std::string key =
      Key().add(subject.key).add(subject.options).add(key_of_frame_program()).text();
  if (const auto stored = cache.json("about", key)) try {
      return {stored->at("objects"), stored->at("needs")};
    } catch (const nlohmann::json::exception&) {
    }
  const Loaded& loaded = shelf.scene();
  About result{.objects = loaded.scene.instances.size(),
               .needs = subject.needs ? subject.needs(loaded) : std::vector<std::string>{}};
  cache.store("about", key, {{"objects", result.objects}, {"needs", result.needs}});
  return result;
}

// The errors of a cell, and its two pictures where they are wanted.
void judge_cell(const Cache& cache, Shelf& shelf, const TruthRecord& truth,
                const std::string& picture_key, bool with_pictures, Cell& cell) {
  const std::string key = Key().add(picture_key).add(truth.key).text();
  const auto picture = [&] {
    return image::load_picture(cache.path("picture", picture_key, "exr"));
  };
  bool known = false;
  if (const auto stored = cache.json("errors", key); stored && cache.has("flip", key, "webp")) try {
      cell.verdict = verdict_from(*stored);
      known = true;
    } catch (const nlohmann::json::exception&) {
    }
  if (!known) {
    const Judged judged = judge(picture(), shelf.truth(truth.file), kinds_of(shelf.scene().scene));
    cell.verdict = judged.verdict;
    cache.store("flip", key, "webp", webp_of(coloured(judged.flip_map)));
    cache.store("errors", key, to_json(cell.verdict));
  }
  if (!with_pictures) return;
  cell.flip = data_uri(*cache.bytes("flip", key, "webp"));
  cell.picture = embedded(cache, "shown", picture_key, [&] { return shown(picture().colour); });
}

void write_all(const Report& report, const std::filesystem::path& directory) {
  const auto write = [&](const char* name, const std::string& text) {
    OutputFile file(directory / name);
    file.write(text);
    file.commit();
  };
  write("report.json", to_json(report).dump(2) + "\n");
  write("report.csv", to_csv(report));
  write("plots.svg", plots(report));
  write("report.html", page(report));
}

} // namespace

Section measure(const Subject& subject, const Plan& plan, const Cache& cache, Devices& devices,
                Work& work) {
  Shelf shelf(subject);
  const auto loaded = [&]() -> const Loaded& { return shelf.scene(); };
  const TruthRecord truth = truth_of(subject, plan, cache, loaded);
  work.traced += truth.traced;
  Drawn drawings = drawn(subject, plan, cache, devices, loaded);
  work.drawn += drawings.pictures;
  work.timed += drawings.timed ? drawings.cells.size() : 0;

  const About scene = about(subject, cache, shelf);
  Section section{.name = subject.name,
                  .path = subject.path,
                  .environment = subject.environment,
                  .width = subject.width,
                  .height = subject.height,
                  .objects = scene.objects,
                  .truth_samples = truth.samples,
                  .truth_error = truth.error,
                  .truth_seconds = truth.seconds,
                  .truth_command = fmt::format("groundglass truth {} -o truth.exr --spp {}",
                                               subject.options, truth.samples),
                  .needs = scene.needs,
                  .cells = std::move(drawings.cells),
                  .measured = drawings.measured};
  section.truth =
      embedded(cache, "shown", truth.key, [&] { return shown(shelf.truth(truth.file).colour); });
  Progress progress(subject.name + ": comparing", static_cast<long>(section.cells.size()));
  for (std::size_t i = 0; i < section.cells.size(); ++i) {
    if (truth::Interruptible::requested()) throw Interrupted{};
    Cell& cell = section.cells[i];
    // The page shows each method once, with the most samples: the backends draw the same, which the
    // errors tell.
    const bool is_shown = i < plan.methods.size() * plan.samples.size()
                          && cell.samples == std::ranges::max(plan.samples);
    judge_cell(cache, shelf, truth, drawings.picture_keys[i], is_shown, cell);
    cell.command = fmt::format(
        "groundglass capture {} -o {}-{}.exr --backend {} --method {} --samples {}",
        subject.options, cell.method, cell.samples, cell.device.backend, cell.method, cell.samples);
    progress.update(static_cast<long>(i + 1));
  }
  const std::vector<Point> all = points_of(section.cells, Measure::all);
  const std::vector<Point> best = points_of(section.cells, Measure::trimmed);
  section.front = pareto_front(all);
  section.front_trimmed = pareto_front(best);
  section.choice = choose(all, best, plan.limit);
  return section;
}

Outcome run(const Plan& plan) {
  make_directory(plan.directory);
  const Cache cache(plan.directory / "cache");
  const truth::Interruptible interruptible;
  Devices devices(plan);
  Outcome outcome{
      .report = {.version = plan.version, .command = plan.command, .limit = plan.limit}};
  for (const Subject& subject : plan.subjects) {
    try {
      outcome.report.sections.push_back(measure(subject, plan, cache, devices, outcome.work));
    } catch (const Interrupted&) {
      outcome.interrupted = true;
      break;
    }
    write_all(outcome.report, plan.directory);
  }
  return outcome;
}

} // namespace gg::report
