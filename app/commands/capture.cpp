// groundglass capture: one picture of a scene, offscreen.
#include "commands/chosen_method.h"
#include "commands/commands.h"
#include "commands/json_file.h"
#include "commands/options.h"
#include "commands/sequence.h"
#include "core/clock.h"
#include "core/error.h"
#include "core/files.h"
#include "core/progress.h"
#include "environment/stack.h"
#include "frame/display.h"
#include "frame/renderer.h"
#include "image/image.h"
#include "needs/left_out.h"
#include "scene/framing.h"
#include "scene/origin.h"
#include "scene/undrawn.h"

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>
#include <utility>

namespace gg::commands {
namespace {

struct CaptureOptions {
  SceneOptions scene;
  DeviceOptions device;
  MethodOptions method;
  Sequence sequence;
  std::string out, json, tonemap = "neutral";
  float exposure = 0.0f; // EV
  int frames = 0;
};

// Everything that can be wrong with where the results go, before the work that makes them.
void check_outputs(const CaptureOptions& o) {
  if (o.out.empty())
    throw Error(ExitCode::usage, "--output", "is missing",
                "Say where the picture goes: -o picture.png; or the frames of an animation: "
                "--frames-out DIR.");
  if (!image::is_writable_extension(o.out))
    throw Error(ExitCode::usage, o.out, "has an extension that is not known",
                "Write .png or .jpg (for display), or .exr, .hdr or .pfm (linear radiance).");
  probe_outputs({o.out, o.json});
}

double median(std::vector<double> values) {
  std::ranges::sort(values);
  const std::size_t n = values.size();
  return n % 2 ? values[n / 2] : 0.5 * (values[n / 2 - 1] + values[n / 2]);
}

// Draws `count` frames after a warm-up and returns milliseconds: of whole frames by the clock, of
// passes by the device.
nlohmann::json time_frames(gpu::Device& device, frame::Renderer& renderer, int count) {
  constexpr int warm_up = 3;          // frames until caches and clocks have settled
  std::vector<double> frames, submit; // submit: of the CPU, recording and submitting, not waiting
  std::uint64_t created = 0;          // objects, allocations and compilations in those frames
  std::map<std::string, std::vector<double>> passes;
  Progress progress("timing", count);
  for (int i = -warm_up; i < count; ++i) {
    device.finish();
    std::map<std::string, double> times;
    const gpu::DeviceCounters before = device.counters();
    const auto start = Clock::now();
    renderer.draw();
    device.finish();
    if (i < 0) continue;
    frames.push_back(ms_since(start));
    const gpu::DeviceCounters after = device.counters();
    submit.push_back(after.record_ms - before.record_ms);
    created += after.created + after.allocations + after.compiled - before.created
               - before.allocations - before.compiled;
    // The passes' own timers are read in a frame of their own: reading them waits for the device
    // after every sample.
    renderer.draw(&times);
    for (const auto& [label, ms] : times)
      passes[label].push_back(ms);
    progress.update(i + 1);
  }
  std::vector<double> sorted = frames;
  std::ranges::sort(sorted);
  nlohmann::json per_pass;
  for (const auto& [label, times] : passes)
    per_pass[label] = median(times);
  // Nearest-rank 95th percentile.
  const std::size_t rank = (sorted.size() * 95 + 99) / 100;
  return {{"frame_ms",
           {{"median", median(frames)},
            {"min", sorted.front()},
            {"max", sorted.back()},
            {"p95", sorted[rank - 1]}}},
          {"pass_ms", per_pass},
          {"cpu_submit_ms", median(submit)},
          {"resources_created", created}};
}

void print_times(std::FILE* to, const nlohmann::json& report, int frames) {
  const auto& ms = report.at("frame_ms");
  fmt::print(to,
             "{} frames of one sample per pixel: median {:.2f} ms, min {:.2f}, 95th percentile "
             "{:.2f}, max {:.2f}; CPU submit time {:.2f} ms; {} resources created\n",
             frames, ms.at("median").get<double>(), ms.at("min").get<double>(),
             ms.at("p95").get<double>(), ms.at("max").get<double>(),
             report.at("cpu_submit_ms").get<double>(), report.at("resources_created").get<int>());
  std::size_t widest = 0;
  for (const auto& [label, pass_ms] : report.at("pass_ms").items())
    widest = std::max(widest, label.size());
  for (const auto& [label, pass_ms] : report.at("pass_ms").items())
    fmt::print(to, "  {:<{}} {:8.2f} ms\n", label, widest, pass_ms.get<double>());
}

void check(const CaptureOptions& o) {
  if (o.method.samples < 1 || o.method.samples > 4096)
    throw Error(ExitCode::usage, "--samples", "must be from 1 to 4096");
  if (o.frames < 0) throw Error(ExitCode::usage, "--frames", "must be 0 or more");
  if (!std::isfinite(o.exposure))
    throw Error(ExitCode::usage, "--exposure", "must be a finite number of stops");
  needs::left_out(o.method.without);
  background_of(o.scene);
  if (o.method.smith != "separable" && o.method.smith != "correlated")
    throw Error(ExitCode::usage, "--smith", "'" + o.method.smith + "' is not known",
                "Choose separable or correlated.");
}

void say_undrawn(const CaptureOptions& o, const scene::Scene& scene) {
  for (const std::string& extension : scene::undrawn(scene))
    note(o.scene.scene + ": " + extension
         + " is read and not drawn yet: its materials are drawn without it");
}

frame::FrameDesc description(const CaptureOptions& o, Size size, const NamedMethod& method) {
  return {.width = size.width,
          .height = size.height,
          .samples = o.method.samples,
          .camera = {},
          .method = method.method,
          .correlated_smith = o.method.smith == "correlated",
          .multiple_scattering = o.method.multiscatter,
          .without = needs::left_out(o.method.without),
          .background = background_of(o.scene)};
}

frame::EnvironmentView lighting(const CaptureOptions& o, const environment::Stack& stack) {
  return {&stack, glm::radians(o.scene.env_rotation), o.scene.env_intensity};
}

image::Image draw(frame::Renderer& renderer, int samples) {
  Progress progress("drawing", samples);
  for (int i = 0; i < samples; ++i) {
    renderer.draw_sample(i);
    progress.update(i + 1);
  }
  return renderer.read();
}

void capture(const CaptureOptions& o, const MethodChoice& choose_method) {
  check_outputs(o);
  check(o);
  const Size size = parse_size(o.scene.size);
  const frame::ToneMap tone_map = frame::parse_tone_map(o.tonemap);
  const ChosenMethod chosen = choose_method(o.scene, o.device, o.method);
  const NamedMethod& method = chosen.named;

  auto start = Clock::now();
  scene::Scene scene = load_scene(o.scene);
  const double load_ms = ms_since(start);
  say_undrawn(o, scene);
  frame::FrameDesc desc = description(o, size, method);
  desc.camera = choose_camera(o.scene, scene, size);
  scene::move_origin_to(desc.camera, scene);
  const auto map = load_environment(o.scene, scene);

  const std::unique_ptr<gpu::Device> device = open_device(o.device);
  start = Clock::now();
  std::optional<environment::Stack> stack;
  if (map) {
    stack = environment::build_or_load(*device, *map);
    device->finish();
    desc.environment = lighting(o, *stack);
  }
  const double environment_ms = ms_since(start);

  frame::Renderer renderer(*device, scene, desc);
  start = Clock::now();
  image::Image picture = draw(renderer, desc.samples);
  const double draw_ms = ms_since(start);
  if (image::is_display_extension(o.out))
    picture = frame::for_display(picture, o.exposure, tone_map);
  nlohmann::json report = {{"device", device->info().name},
                           {"driver", device->info().driver},
                           {"backend", device->info().backend},
                           {"surface", device->info().surface},
                           {"method", method.name},
                           {"width", size.width},
                           {"height", size.height},
                           {"samples", desc.samples},
                           {"device_memory_bytes", device->memory_bytes()},
                           {"triangles", renderer.triangle_count()},
                           {"passes", renderer.pass_labels()},
                           {"load_ms", load_ms},
                           {"environment_ms", environment_ms},
                           {"draw_ms", draw_ms}};
  if (o.frames > 0) report.update(time_frames(*device, renderer, o.frames));
  image::write(o.out, picture);
  if (!o.json.empty()) write_json(o.json, report);
  if (std::FILE* const to = text_stream({o.out, o.json}); o.json != "-") {
    fmt::print(to, "{}: {} x {} pixels, {} on {}, {} sample{} per pixel in {:.0f} ms\n", o.out,
               size.width, size.height, method.name, device->info().backend, desc.samples,
               desc.samples == 1 ? "" : "s", draw_ms);
    if (o.frames > 0) print_times(to, report, o.frames);
  }
  if (!chosen.within_limit)
    throw Error(ExitCode::different, o.method.budget ? "--budget" : "--max-error",
                "no method meets it",
                "The picture is drawn by the one that comes nearest: " + method.name + ".");
}

// The frames of an animation, one file each. Device and environment serve them all, and what is on the device as long as nothing
// but the places of things changes.
void capture_sequence(CaptureOptions o, const MethodChoice& choose_method) {
  check(o);
  if (!o.out.empty() || !o.json.empty() || o.frames > 0)
    throw Error(ExitCode::usage, "--frames-out", "is given with -o, --json or --frames",
                "Those are of one picture: leave them out.");
  const Size size = parse_size(o.scene.size);
  const frame::ToneMap tone_map = frame::parse_tone_map(o.tonemap);
  check_sequence(o.sequence, o.scene);
  o.scene.time = o.sequence.from;
  const NamedMethod method = choose_method(o.scene, o.device, o.method).named;
  scene::File file(o.scene.scene);
  scene::Scene scene = load_scene(o.scene, file);
  say_undrawn(o, scene);
  const std::vector<SequenceFrame> frames = frames_of(o.sequence, *scene.posed);
  begin_sequence(o.sequence, o.scene,
                 fmt::format("{} {} {} {} {} {} {}{}", method.name, o.method.smith,
                             o.method.multiscatter, o.method.samples, o.device.backend, o.exposure,
                             o.tonemap,
                             o.method.without.empty() ? "" : " without " + o.method.without));
  // A camera that is framed by what it sees would move with it: the first frame's stays.
  const scene::Camera framed = choose_camera(o.scene, scene, size);
  const bool stays = camera_is_framed(o.scene, scene);

  const std::unique_ptr<gpu::Device> device = open_device(o.device);
  const auto map = load_environment(o.scene, scene);
  std::optional<environment::Stack> stack;
  if (map) stack = environment::build_or_load(*device, *map);
  Progress progress("drawing frames", static_cast<long>(frames.size()));
  std::optional<frame::Renderer> renderer; // of `scene`
  std::size_t kept = 0;
  for (std::size_t i = 0; i < frames.size(); ++i) {
    if (std::filesystem::exists(frames[i].path)) {
      ++kept;
    } else {
      o.scene.time = frames[i].time;
      scene::Scene posed = load_scene(o.scene, file);
      frame::FrameDesc desc = description(o, size, method);
      desc.camera = stays ? framed : choose_camera(o.scene, posed, size);
      if (stays) scene::fit_depth(desc.camera, posed);
      scene::move_origin_to(desc.camera, posed);
      if (stack) desc.environment = lighting(o, *stack);
      const bool keeps = renderer && only_moved(scene, posed);
      if (!keeps) renderer.reset();
      if (keeps) {
        scene.instances = std::move(posed.instances);
        scene.lights = std::move(posed.lights);
        scene.bounds = posed.bounds;
        renderer->scene_changed();
        renderer->set(desc);
      } else {
        scene = std::move(posed);
        renderer.emplace(*device, scene, desc);
      }
      image::Image picture = draw(*renderer, desc.samples);
      if (image::is_display_extension(frames[i].path))
        picture = frame::for_display(picture, o.exposure, tone_map);
      image::write(frames[i].path, picture);
    }
    progress.update(static_cast<long>(i) + 1);
  }
  fmt::print("{}: {} frames of {} x {} pixels of the animation '{}', {} to {} s, {} on {}{}\n",
             o.sequence.directory, frames.size(), size.width, size.height, scene.posed->animation,
             frames.front().time, frames.back().time, method.name, device->info().backend,
             kept ? fmt::format("; {} were there already", kept) : "");
}

} // namespace

void add_capture(Command program, MethodChoice choose_method) {
  auto options = std::make_shared<CaptureOptions>();
  Command command = program.subcommand("capture", "Draw a scene into a picture file");
  add_options(command, options->scene);
  add_background(command, options->scene);
  command.option(
      "-o,--output", &options->out,
      "Picture to write: .png, .jpg, .exr, .hdr or .pfm; - for standard output, as .png");
  add_options(command, options->sequence);
  add_options(command, options->device);
  add_options(command, options->method);
  add_automatic(command, options->method);
  command.option("--exposure", &options->exposure,
                 "Stops of brightness added for display (.png, .jpg)");
  command.option("--tonemap", &options->tonemap, "none, neutral, aces or agx (.png, .jpg)");
  command.option("--frames", &options->frames,
                 "Time so many frames of one sample per pixel and print the times");
  command.option("--json", &options->json,
                 "Write device, sizes and times to this file, or to standard output: -");
  command.action([options, choose_method = std::move(choose_method)] {
    options->sequence.directory.empty() ? capture(*options, choose_method)
                                        : capture_sequence(*options, choose_method);
  });
}

} // namespace gg::commands
