#include "viewer/truth_run.h"

#include "core/clock.h"
#include "core/error.h"
#include "truth/render.h"

#include <utility>

namespace gg::viewer {
namespace {

image::Picture picture_of(const truth::Film& film, const scene::Scene& scene) {
  image::Picture picture{.name = "truth", .colour = image::Image(film.width(), film.height(), 3)};
  picture.standard_error.emplace(film.width(), film.height(), 3);
  for (int y = 0; y < film.height(); ++y)
    for (int x = 0; x < film.width(); ++x) {
      const truth::Pixel& pixel = film.at(x, y);
      const glm::dvec3 mean = film.mean(pixel), error = film.standard_error(pixel);
      for (int c = 0; c < 3; ++c) {
        picture.colour.at(x, y, c) = static_cast<float>(mean[c]);
        picture.standard_error->at(x, y, c) = static_cast<float>(error[c]);
      }
      const auto id = static_cast<float>(std::max(pixel.object, 0));
      picture.id.push_back(id);
      picture.coverage.push_back(id > 0.0f ? 1.0f : 0.0f);
    }
  for (std::size_t i = 0; i < scene.instances.size(); ++i)
    picture.object_names[static_cast<int>(i) + 1] = scene.instances[i].name;
  return picture;
}

} // namespace

void TruthRun::start(Desc desc) {
  cancel();
  Run& run = runs_.emplace_back();
  run.thread = std::thread([this, &run, desc = std::move(desc)] {
    try {
      trace(run, desc);
    } catch (const std::exception& error) {
      Report failed;
      failed.failed = error.what();
      publish(run, std::move(failed));
    }
    run.finished = true;
  });
}

void TruthRun::cancel() {
  {
    const std::lock_guard lock(mutex_);
    for (Run& run : runs_)
      run.stop = true;
    report_.reset();
    frame_.reset();
  }
  std::erase_if(runs_, [](Run& run) {
    if (run.finished) run.thread.join();
    return run.finished.load();
  });
}

void TruthRun::stop() {
  cancel();
  for (Run& run : runs_)
    run.thread.join();
  runs_.clear();
}

void TruthRun::publish(const Run& run, Report report) {
  {
    const std::lock_guard lock(mutex_);
    if (run.stop) return;
    report_ = std::make_shared<const Report>(std::move(report));
  }
  wake_();
}

void TruthRun::compare_with(std::shared_ptr<const image::Image> frame, std::vector<int> objects) {
  const std::lock_guard lock(mutex_);
  frame_ = std::move(frame);
  objects_ = std::move(objects);
}

std::shared_ptr<const TruthRun::Report> TruthRun::take() {
  const std::lock_guard lock(mutex_);
  return std::exchange(report_, nullptr);
}

bool TruthRun::ready() const {
  const std::lock_guard lock(mutex_);
  return report_ != nullptr;
}

void TruthRun::trace(Run& run, const Desc& desc) {
  std::optional<truth::EnvironmentLight> light;
  if (desc.map) light.emplace(environment::Map(*desc.map), desc.rotation, desc.intensity);
  if (run.stop) return;
  const truth::Camera camera(desc.camera, desc.width, desc.height);
  const truth::Integrator integrator(
      *desc.scene, light ? &*light : nullptr,
      camera.orthographic() ? std::nullopt : std::optional(camera.eye()),
      {.smith = desc.correlated_smith ? truth::Smith::correlated : truth::Smith::separable,
       .multiple_scattering = desc.multiple_scattering,
       .background = {.sigma = static_cast<double>(desc.background.sigma),
                      .plain = desc.background.plain
                                   ? std::optional(glm::dvec3(*desc.background.plain))
                                   : std::nullopt}});
  truth::Film film(desc.width, desc.height);
  const auto start = Clock::now();
  // A picture is shown, and compared, as often as takes a fifth of the time.
  double spent = 0.0;
  std::optional<image::Comparison> comparison;
  const auto report = [&](const truth::Film& now, double error) {
    const long samples = now.samples();
    const double elapsed = seconds_since(start);
    if (spent > 0.2 * elapsed && samples < desc.samples) return;
    Report made{.picture = picture_of(now, *desc.scene),
                .samples = samples,
                .error = error,
                .seconds = elapsed};
    std::shared_ptr<const image::Image> frame;
    std::vector<int> objects;
    {
      const std::lock_guard lock(mutex_);
      frame = frame_;
      objects = objects_;
    }
    if (frame && frame->width == desc.width && frame->height == desc.height && samples >= 2) {
      image::Picture test{.name = "frame", .colour = *frame};
      try {
        comparison = image::compare(test, made.picture, objects);
      } catch (const Error&) { // the picked object covers no pixel
        comparison = image::compare(test, made.picture);
      }
    }
    made.comparison = comparison;
    publish(run, std::move(made));
    spent += seconds_since(start) - elapsed;
  };
  truth::render(integrator, camera, {.samples = desc.samples}, film,
                {.report = report, .stop = [&run] { return run.stop.load(); }});
}

} // namespace gg::viewer
