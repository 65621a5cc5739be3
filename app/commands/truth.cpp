// groundglass truth: the scene path traced, with its own error stated.
#include "commands/commands.h"
#include "commands/json_file.h"
#include "commands/options.h"
#include "core/clock.h"
#include "core/error.h"
#include "core/files.h"
#include "core/progress.h"
#include "frame/display.h"
#include "scene/origin.h"
#include "truth/interrupt.h"
#include "truth/render.h"

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <filesystem>
#include <limits>
#include <memory>
#include <numbers>
#include <optional>
#include <vector>

namespace gg::commands {
namespace {

namespace fs = std::filesystem;

struct TruthOptions {
  SceneOptions scene;
  std::vector<std::string> out;
  std::string exr, png; // those of `out`
  std::string json, smith = "separable", tonemap = "neutral";
  float exposure = 0.0f;         // EV
  std::optional<double> preview; // seconds
  std::optional<long> spp;
  std::optional<double> error, clamp;
  std::uint64_t seed = 0;
  int threads = 0;
  bool surface_only = false, resume = false, half = false, multiscatter = false;
};

constexpr long default_spp = 256;
// Beyond this a float's 24 bits do not tell the mean from its neighbours anyway.
constexpr long most_spp = 1L << 30;
constexpr double most_error = 10.0; // ten times as large as what it is the error of
constexpr int most_threads = 1024;

// What messages call the picture.
const std::string& name_of(const TruthOptions& o) {
  return o.exr.empty() ? o.png : o.exr;
}

// An .exr, a .png, or one of each.
void sort_outputs(TruthOptions& o) {
  for (const std::string& path : o.out) {
    const fs::path extension = fs::path(path).extension();
    const bool to_stream = extension.empty() && destination_of(path).is_stream;
    if (extension != ".exr" && extension != ".png" && !to_stream)
      throw Error(
          ExitCode::usage, path, "is neither an .exr nor a .png file",
          "-o truth.exr keeps the error and the object ids in OpenEXR channels; -o truth.png "
          "is for looking at.");
    std::string& place = extension == ".png" ? o.png : o.exr;
    if (!place.empty())
      throw Error(ExitCode::usage, path, "is the second picture of its kind",
                  "Ask for one .exr, one .png, or one of each.");
    place = path;
  }
}

void check(const TruthOptions& o) {
  if (o.exr.empty() && (o.resume || o.half))
    throw Error(ExitCode::usage, o.resume ? "--resume" : "--half", "needs an .exr file",
                "Add -o truth.exr.");
  if (o.preview && o.png.empty())
    throw Error(ExitCode::usage, "--preview", "needs a .png file to write", "Add -o truth.png.");
  if (o.preview && !(*o.preview > 0.0 && std::isfinite(*o.preview)))
    throw Error(ExitCode::usage, "--preview", "must be a number of seconds above 0");
  if (!std::isfinite(o.exposure))
    throw Error(ExitCode::usage, "--exposure", "must be a finite number of stops");
  if (o.spp && (*o.spp < 2 || *o.spp > most_spp))
    throw Error(ExitCode::usage, "--spp", fmt::format("must be from 2 to {}", most_spp),
                "One sample says nothing about its error.");
  if (o.error && !(*o.error > 0.0 && *o.error <= most_error))
    throw Error(ExitCode::usage, "--error", fmt::format("must be more than 0, to {}", most_error),
                "0.05 is 5 %.");
  if (o.clamp && !(*o.clamp > 0.0 && std::isfinite(*o.clamp)))
    throw Error(ExitCode::usage, "--clamp", "must be a radiance above 0");
  if (o.threads < 0 || o.threads > most_threads)
    throw Error(ExitCode::usage, "--threads", fmt::format("must be from 0 to {}", most_threads));
  if (o.smith != "separable" && o.smith != "correlated")
    throw Error(ExitCode::usage, "--smith", "'" + o.smith + "' is not known",
                "Choose separable or correlated.");
  probe_outputs({o.exr, o.png, o.json});
}

std::string numbers_of(const scene::Camera& camera) {
  std::string text = camera.orthographic ? fmt::format("orthographic {}", camera.magnification.y)
                                         : fmt::format("fovy {}", camera.fovy);
  for (int c = 0; c < 4; ++c)
    text += fmt::format(" {},{},{}", camera.world[c].x, camera.world[c].y, camera.world[c].z);
  return text;
}

// What the samples depend on, besides the files' contents: to be found in the header, and to be the
// same where a picture is resumed.
std::map<std::string, std::string> settings_of(const TruthOptions& o, const scene::Camera& camera) {
  std::string materials;
  for (const std::string& material : o.scene.materials)
    materials += (materials.empty() ? "" : " ") + material;
  std::map<std::string, std::string> settings = {
      {"scene", o.scene.scene},
      {"materials", materials},
      {"environment", o.scene.env.empty() ? "default" : o.scene.env},
      {"environmentRotation", fmt::format("{}", o.scene.env_rotation)},
      {"environmentIntensity", fmt::format("{}", o.scene.env_intensity)},
      {"camera", numbers_of(camera)},
      {"seed", std::to_string(o.seed)},
      {"smith", o.smith},
      {"scattering", o.multiscatter ? "multiple" : "single"},
      {"clamp", o.clamp ? fmt::format("{}", *o.clamp) : ""},
      {"transport", o.surface_only ? "surface only" : "full"}};
  if (o.scene.background != SceneOptions{}.background) settings["background"] = o.scene.background;
  return settings;
}

truth::Film film_of(const TruthOptions& o, const std::map<std::string, std::string>& settings,
                    Size size) {
  if (!o.resume || !fs::exists(o.exr)) return {size.width, size.height};
  const image::Exr before = image::read_exr(o.exr);
  truth::Film film = truth::Film::from_exr(before, o.exr);
  if (film.width() != size.width || film.height() != size.height)
    throw Error(ExitCode::usage, o.exr,
                fmt::format("is {} x {} pixels, not {} x {}", film.width(), film.height(),
                            size.width, size.height),
                "Ask for the same --size, or leave --resume out to start again.");
  for (const auto& [key, value] : settings) {
    const auto found = before.attributes.find(key);
    const std::string was = found != before.attributes.end() ? found->second : "";
    if (was != value)
      throw Error(ExitCode::usage, o.exr,
                  fmt::format("was rendered with {} '{}', not '{}'", key, was, value),
                  "Ask for the same, or leave --resume out to start again.");
  }
  return film;
}

std::string command_line(const TruthOptions& o, long spp) {
  std::string line =
      fmt::format("groundglass truth {} -o {}{} --spp {} --seed {}", in_shell(o.scene.scene),
                  in_shell(name_of(o)), typed_view(o.scene), spp, o.seed);
  if (o.smith != "separable") line += " --smith " + o.smith;
  if (o.multiscatter) line += " --multiscatter";
  if (o.clamp) line += fmt::format(" --clamp {}", *o.clamp);
  if (o.half) line += " --half";
  return line + (o.surface_only ? " --surface-only" : "");
}

image::Exr picture_of(const truth::Film& film, const scene::Scene& scene,
                      const std::map<std::string, std::string>& settings, const TruthOptions& o) {
  image::Exr exr = film.to_exr();
  for (const auto& [key, value] : settings)
    exr.attributes[key] = value;
  exr.attributes["command"] = command_line(o, film.samples());
  for (std::size_t i = 0; i < scene.instances.size(); ++i)
    exr.attributes[fmt::format("object.{}", i + 1)] = scene.instances[i].name;
  return exr;
}

// Small, for keeping: the standard error stays in the header, as its mean and as the relative error.
image::Exr halved(image::Exr picture) {
  for (const char* channel :
       {"stderr.R", "stderr.G", "stderr.B", "batch.R", "batch.G", "batch.B", "clamped"})
    picture.channels.erase(channel);
  picture.half = true;
  return picture;
}

void write_png(const truth::Film& film, const TruthOptions& o, frame::ToneMap tone_map) {
  image::write(o.png, frame::for_display(film.to_image(), o.exposure, tone_map));
}

void trace(TruthOptions o) {
  sort_outputs(o);
  check(o);
  const frame::ToneMap tone_map = frame::parse_tone_map(o.tonemap);
  const Size size = parse_size(o.scene.size);
  const frame::Background background = background_of(o.scene);
  scene::Scene scene = load_scene(o.scene);
  scene::Camera view = choose_camera(o.scene, scene, size);
  const auto settings = settings_of(o, view);
  scene::move_origin_to(view, scene);
  truth::Film film = film_of(o, settings, size);

  std::optional<truth::EnvironmentLight> environment;
  if (auto map = load_environment(o.scene, scene))
    environment.emplace(std::move(*map),
                        static_cast<double>(o.scene.env_rotation) * std::numbers::pi / 180.0,
                        static_cast<double>(o.scene.env_intensity));
  const truth::Camera camera(view, size.width, size.height);
  const truth::Integrator integrator(
      scene, environment ? &*environment : nullptr,
      camera.orthographic() ? std::nullopt : std::optional(camera.eye()),
      {.smith = o.smith == "correlated" ? truth::Smith::correlated : truth::Smith::separable,
       .transport = o.surface_only ? truth::Transport::surface_only : truth::Transport::full,
       .multiple_scattering = o.multiscatter,
       .clamp = o.clamp.value_or(INFINITY),
       .background = {.sigma = static_cast<double>(background.sigma),
                      .plain = background.plain ? std::optional(glm::dvec3(*background.plain))
                                                : std::nullopt}});

  const truth::RenderDesc desc{.seed = o.seed,
                               .samples = o.spp.value_or(o.error ? most_spp : default_spp),
                               .error = o.error.value_or(0.0),
                               .threads = o.threads};
  const auto start = Clock::now();
  bool complete = false;
  {
    const truth::Interruptible interruptible;
    // The error falls with the root of the samples, so the square of what is asked for over what is
    // there is the part of the work that is done.
    constexpr long steps = 10000;
    Progress progress("tracing", steps);
    auto shown = start;
    const auto report = [&](const truth::Film& now, double error) {
      const long samples = now.samples();
      const double ratio =
          samples >= truth::least_samples && error > 0.0 ? desc.error / error : 0.0;
      const double part =
          std::max(static_cast<double>(samples) / static_cast<double>(desc.samples), ratio * ratio);
      // One sample does not know its error.
      progress.update(static_cast<long>(steps * std::min(1.0, part)),
                      samples < 2 ? "1 sample per pixel"
                                  : fmt::format("{} samples per pixel, error {:.2f} %", samples,
                                                100.0 * error));
      if (!o.preview || seconds_since(shown) < *o.preview) return;
      shown = Clock::now();
      write_png(now, o, tone_map);
    };
    complete = truth::render(integrator, camera, desc, film,
                             {.report = report, .stop = truth::Interruptible::requested});
  }
  const double seconds = seconds_since(start);
  if (film.samples() < 2)
    throw Error(ExitCode::interrupted, name_of(o), "interrupted before there was anything to keep");

  const image::Exr picture = picture_of(film, scene, settings, o);
  if (!o.exr.empty()) image::write_exr(o.exr, o.half ? halved(picture) : picture);
  if (!o.png.empty()) write_png(film, o, tone_map);
  if (!o.json.empty())
    write_json(o.json,
               {{"width", size.width},
                {"height", size.height},
                {"samples", film.samples()},
                {"seconds", seconds},
                {"relative_error", film.relative_error()},
                {"mean_standard_error", std::stod(picture.attributes.at("meanStandardError"))},
                {"clamped_share", film.clamped_share()},
                {"complete", complete},
                {"command", picture.attributes.at("command")}});
  fmt::print(text_stream({o.exr, o.png, o.json}),
             "{}{}: {} x {} pixels, {} samples per pixel, error {:.2f} %, {:.1f} s{}\n", name_of(o),
             o.exr.empty() || o.png.empty() ? "" : " and " + o.png, size.width, size.height,
             film.samples(), 100.0 * film.relative_error(), seconds,
             o.clamp
                 ? fmt::format("; clamping took {:.3g} % of the light, which the error leaves out",
                               100.0 * film.clamped_share())
                 : "");
  if (!complete)
    throw Error(ExitCode::interrupted, name_of(o),
                fmt::format("interrupted; {} samples per pixel are kept", film.samples()),
                o.exr.empty() ? "With -o truth.exr, --resume could go on from there."
                              : "The same command with --resume goes on from there.");
}

} // namespace

void add_truth(Command program) {
  auto options = std::make_shared<TruthOptions>();
  Command command =
      program.subcommand("truth", "Path trace a scene: the reference, with its own error");
  add_options(command, options->scene);
  add_background(command, options->scene);
  command
      .option("-o,--output", &options->out,
              "Picture to write: .exr (radiance, error, object ids), .png (for display), or one of "
              "each")
      .required();
  const Option spp = command.option(
      "--spp", &options->spp, fmt::format("Samples per pixel ({} if not given)", default_spp));
  command
      .option("--error", &options->error,
              "In place of --spp: trace until the relative error is this small, 0.05 for 5 %: a "
              "pixel's standard error over (its mean + 0.1), RMS over the objects' pixels")
      .excludes(spp);
  command.option("--seed", &options->seed, "Seed of the random numbers: another seed, other noise");
  command.option("--smith", &options->smith, "Shadowing: separable (Walter 2007) or correlated");
  command.flag("--multiscatter", options->multiscatter,
               "Give back the energy of multiple scattering between a metal's facets");
  command.option(
      "--clamp", &options->clamp,
      "The most radiance that one path of scattered light may bring: less noise, and a picture "
      "that is darker by a share that is printed");
  command.flag("--surface-only", options->surface_only,
               "Light each visible point by the environment alone: no shadows, no second bounce");
  command.flag("--resume", options->resume, "Go on from the samples in the .exr that -o names");
  command.flag(
      "--half", options->half,
      "Write a smaller .exr: 16-bit floats, no standard error of each pixel; --resume cannot "
      "go on from it");
  command.option("--exposure", &options->exposure, "Stops of brightness added for display (.png)");
  command.option("--tonemap", &options->tonemap, "none, neutral, aces or agx (.png)");
  command.option("--preview", &options->preview,
                 "While it traces, write the .png every so many seconds");
  command.option("--threads", &options->threads, "Threads; 0: one for each core");
  command.option("--json", &options->json,
                 "Write samples, seconds and error to this file, or to standard output: -");
  command.action([options] { trace(*options); });
}

} // namespace gg::commands
