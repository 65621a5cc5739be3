#include "report/truths.h"

#include "core/clock.h"
#include "core/error.h"
#include "core/progress.h"
#include "report/key.h"
#include "truth/interrupt.h"
#include "truth/render.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

namespace gg::report {
namespace {

constexpr long no_limit = 1L << 30; // samples: the error decides

bool enough(const TruthRecord& record, const Plan& plan) {
  return plan.truth_error > 0.0 ? record.error <= plan.truth_error
                                : record.samples >= plan.truth_samples;
}

std::string key_of(const Subject& subject, const Plan& plan) {
  Key key;
  key.add(subject.key).add(plan.correlated_smith ? "correlated" : "separable");
  if (plan.multiple_scattering) key.add("multiple scattering");
  return key.add(key_of_truth_program()).text();
}

std::optional<TruthRecord> stored(const Cache& cache, const std::string& key) {
  const auto about = cache.json("truth", key);
  if (!about || !cache.has("truth", key, "exr")) return std::nullopt;
  try {
    return TruthRecord{.file = cache.path("truth", key, "exr"),
                       .key = about->at("key"),
                       .samples = about->at("samples"),
                       .error = about->at("error"),
                       .seconds = about->at("seconds")};
  } catch (const nlohmann::json::exception&) {
    return std::nullopt;
  }
}

// What an earlier run left, or nothing yet.
truth::Film film_of(const std::optional<TruthRecord>& before, const Subject& subject) {
  if (before) try {
      truth::Film film = truth::Film::from_exr(image::read_exr(before->file), before->file);
      if (film.width() == subject.width && film.height() == subject.height) return film;
    } catch (const Error& damaged) {
      note(std::string(damaged.what()) + " It is traced again.");
    }
  return {subject.width, subject.height};
}

image::Exr exr_of(const truth::Film& film, const Subject& subject, const Loaded& loaded) {
  image::Exr exr = film.to_exr();
  exr.attributes["command"] =
      fmt::format("groundglass truth {} --spp {}", subject.options, film.samples());
  for (std::size_t i = 0; i < loaded.scene.instances.size(); ++i)
    exr.attributes[fmt::format("object.{}", i + 1)] = loaded.scene.instances[i].name;
  return exr;
}

bool trace(const Subject& subject, const Plan& plan, const Loaded& loaded, truth::Film& film) {
  std::optional<truth::EnvironmentLight> environment;
  if (loaded.environment)
    environment.emplace(*loaded.environment, static_cast<double>(loaded.rotation),
                        static_cast<double>(loaded.intensity));
  const truth::Camera camera(loaded.camera, subject.width, subject.height);
  const truth::Integrator integrator(
      loaded.scene, environment ? &*environment : nullptr,
      camera.orthographic() ? std::nullopt : std::optional(camera.eye()),
      {.smith = plan.correlated_smith ? truth::Smith::correlated : truth::Smith::separable,
       .multiple_scattering = plan.multiple_scattering});
  const truth::RenderDesc desc{.samples = plan.truth_error > 0.0 ? no_limit : plan.truth_samples,
                               .error = plan.truth_error};
  Progress progress(subject.name + ": truth", 1000);
  const auto report = [&](const truth::Film& now, double error) {
    const long samples = now.samples();
    const double part =
        plan.truth_error > 0.0
            ? (plan.truth_error / error) * (plan.truth_error / error)
            : static_cast<double>(samples) / static_cast<double>(plan.truth_samples);
    // One sample does not know its error.
    progress.update(
        static_cast<long>(1000.0 * std::min(1.0, part)),
        samples < 2 ? "1 sample per pixel"
                    : fmt::format("{} samples per pixel, error {:.2f} %", samples, 100.0 * error));
  };
  return truth::render(integrator, camera, desc, film,
                       {.report = report, .stop = truth::Interruptible::requested});
}

} // namespace

TruthRecord truth_of(const Subject& subject, const Plan& plan, const Cache& cache,
                     const std::function<const Loaded&()>& loaded) {
  const std::string key = key_of(subject, plan);
  const std::optional<TruthRecord> before = stored(cache, key);
  if (before && enough(*before, plan)) return *before;

  const Loaded& scene = loaded();
  truth::Film film = film_of(before, subject);
  const long had = film.samples();
  const auto start = Clock::now();
  const bool complete = trace(subject, plan, scene, film);
  const double seconds = seconds_since(start);
  if (film.samples() < 2) throw Interrupted{}; // one sample says nothing about its error
  TruthRecord record{.file = cache.path("truth", key, "exr"),
                     .key = Key().add(key).add(static_cast<double>(film.samples())).text(),
                     .samples = film.samples(),
                     .error = film.relative_error(),
                     .seconds = seconds + (had > 0 ? before->seconds : 0.0),
                     .traced = true};
  image::write_exr(record.file, exr_of(film, subject, scene));
  cache.store("truth", key,
              {{"scene", subject.path},
               {"key", record.key},
               {"samples", record.samples},
               {"error", record.error},
               {"seconds", record.seconds}});
  if (!complete) throw Interrupted{};
  return record;
}

} // namespace gg::report
