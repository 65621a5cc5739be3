// groundglass capture: one picture of a scene, offscreen.
#include "commands/auto_method.h"
#include "commands/commands.h"
#include "commands/options.h"
#include "core/error.h"
#include "core/files.h"
#include "core/progress.h"
#include "environment/stack.h"
#include "frame/display.h"
#include "frame/renderer.h"
#include "image/image.h"
#include "scene/undrawn.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <memory>

namespace gg::commands {
namespace {

struct Options {
  SceneOptions scene;
  DeviceOptions device;
  MethodOptions method;
  std::string out, json, tonemap = "neutral";
  float exposure = 0.0f; // EV
  int frames = 0;
};

using Clock = std::chrono::steady_clock;
double ms_since(Clock::time_point start) {
  return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

// Everything that can be wrong with where the results go, before the work that makes them.
void check_outputs(const Options& o) {
  if (!image::is_writable_extension(o.out))
    throw Error(ExitCode::usage, o.out, "has an extension that is not known",
                "Write .png (for display), or .exr, .hdr or .pfm (linear radiance).");
  for (const std::string& path : {o.out, o.json})
    if (!path.empty()) OutputFile probe(path);
}

double median(std::vector<double> values) {
  std::ranges::sort(values);
  const std::size_t n = values.size();
  return n % 2 ? values[n / 2] : 0.5 * (values[n / 2 - 1] + values[n / 2]);
}

// Draws `count` frames after a warm-up and returns milliseconds: of whole frames by the clock, of
// passes by the device.
nlohmann::json time_frames(gpu::Device& device, frame::Renderer& renderer, int count) {
  constexpr int warm_up = 3;             // frames until caches and clocks have settled
  std::vector<double> frames, recording; // of the host: recording and submitting, without waiting
  std::uint64_t made = 0;                // objects, allocations and compilations in those frames
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
    recording.push_back(after.record_ms - before.record_ms);
    made += after.created + after.allocations + after.compiled - before.created - before.allocations
            - before.compiled;
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
  return {{"ms",
           {{"median", median(frames)},
            {"min", sorted.front()},
            {"max", sorted.back()},
            {"p95", sorted[rank - 1]}}},
          {"ms_per_pass", per_pass},
          {"record_ms", median(recording)},
          {"made", made}};
}

void capture(const Options& o) {
  check_outputs(o);
  if (o.method.samples < 1 || o.method.samples > 4096)
    throw Error(ExitCode::usage, "--samples", "must be from 1 to 4096");
  if (o.frames < 0) throw Error(ExitCode::usage, "--frames", "must be 0 or more");
  if (!std::isfinite(o.exposure))
    throw Error(ExitCode::usage, "--exposure", "must be a finite number of stops");
  if (o.method.smith != "separable" && o.method.smith != "correlated")
    throw Error(ExitCode::usage, "--smith", "'" + o.method.smith + "' is not known",
                "Choose separable or correlated.");
  const Size size = parse_size(o.scene.size);
  const frame::ToneMap tone_map = frame::parse_tone_map(o.tonemap);
  const NamedMethod method = choose_method(o.scene, o.device, o.method);

  auto start = Clock::now();
  const scene::Scene scene = load_scene(o.scene);
  const double load_ms = ms_since(start);
  for (const std::string& extension : scene::undrawn(scene))
    note(o.scene.scene + ": " + extension
         + " is read and not drawn yet: its materials are drawn without it");
  frame::FrameDesc desc{.width = size.width,
                        .height = size.height,
                        .samples = o.method.samples,
                        .camera = choose_camera(o.scene, scene, size),
                        .method = method.method,
                        .correlated_smith = o.method.smith == "correlated",
                        .multiple_scattering = o.method.multiscatter};
  const auto map = load_environment(o.scene, scene);

  const std::unique_ptr<gpu::Device> device = open_device(o.device);
  start = Clock::now();
  std::optional<environment::Stack> stack;
  if (map) {
    stack = environment::build(*device, *map);
    device->finish();
    desc.environment = {&*stack, glm::radians(o.scene.env_rotation), o.scene.env_intensity};
  }
  const double environment_ms = ms_since(start);

  frame::Renderer renderer(*device, scene, desc);
  {
    Progress progress("drawing", desc.samples);
    for (int i = 0; i < desc.samples; ++i) {
      renderer.draw_sample(i);
      progress.update(i + 1);
    }
  }
  image::Image picture = renderer.read();
  if (std::filesystem::path(o.out).extension() == ".png")
    picture = frame::for_display(picture, o.exposure, tone_map);
  nlohmann::json report = {{"device", device->info().name},
                           {"driver", device->info().driver},
                           {"backend", device->info().backend},
                           {"surface", device->info().surface},
                           {"method", method.name},
                           {"width", size.width},
                           {"height", size.height},
                           {"samples", desc.samples},
                           {"bytes", device->memory_bytes()},
                           {"triangles", renderer.triangle_count()},
                           {"passes", renderer.pass_labels()},
                           {"load_ms", load_ms},
                           {"environment_ms", environment_ms}};
  if (o.frames > 0) report.update(time_frames(*device, renderer, o.frames));
  image::write(o.out, picture);
  if (!o.json.empty()) {
    OutputFile json(o.json);
    json.write(report.dump(2) + "\n");
    json.commit();
  }
}

} // namespace

void add_capture(Command program) {
  auto options = std::make_shared<Options>();
  Command command = program.subcommand("capture", "Draw a scene into a picture file");
  add_options(command, options->scene);
  command.option("-o,--output", &options->out, "Picture to write: .png, .exr, .hdr or .pfm")
      .required();
  add_options(command, options->device);
  add_options(command, options->method);
  command.option("--exposure", &options->exposure, "Stops of brightness added for display (.png)");
  command.option("--tonemap", &options->tonemap, "none, neutral, aces or agx (.png)");
  command.option("--frames", &options->frames, "Time so many frames; see --json");
  command.option("--json", &options->json, "Write device, sizes and times to this file");
  command.action([options] { capture(*options); });
}

} // namespace gg::commands
