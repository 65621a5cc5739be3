// groundglass view: the interactive viewer.
#include "commands/commands.h"
#include "commands/json_file.h"
#include "commands/options.h"
#include "core/error.h"
#include "core/files.h"
#include "frame/display.h"
#include "needs/left_out.h"
#include "scene/undrawn.h"
#include "viewer/viewer.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <memory>
#include <sstream>

namespace gg::commands {
namespace {

struct ViewOptions {
  SceneOptions scene;
  DeviceOptions device;
  MethodOptions method;
  std::string tonemap = "neutral";
  float exposure = 0.0f, scale = 0.0f;
  bool no_panel = false, keep_method = false;
  std::string inspect, debug_view;
  std::string json;          // where the times of --bench-orbit go
  viewer::Settings settings; // what has no counterpart elsewhere
};

std::string words_of(const glm::vec3& v) {
  return fmt::format("{},{},{}", v.x, v.y, v.z);
}

SceneOptions options_of(const viewer::View& view, int width, int height) {
  SceneOptions o;
  o.scene = view.scene;
  o.time = view.time;
  o.animation = view.animation;
  o.materials = view.all_materials();
  o.env = view.env;
  o.env_rotation = view.env_rotation;
  o.env_intensity = view.env_intensity;
  o.background = view.background;
  o.size = fmt::format("{}x{}", width, height);
  if (!view.place) {
    o.camera = view.camera;
    return o;
  }
  o.eye = words_of(view.place->eye);
  o.target = words_of(view.place->target);
  o.up = words_of(view.place->up);
  if (view.place->ortho > 0.0f)
    o.ortho = view.place->ortho;
  else
    o.fovy = view.place->fovy;
  return o;
}

std::string words(const DeviceOptions& device, const std::string& command, const viewer::View& view,
                  int width, int height, const std::string& output) {
  std::string line = command + " " + in_shell(view.scene);
  if (!output.empty()) line += " -o " + in_shell(output);
  SceneOptions scene = options_of(view, width, height);
  if (command == "report") scene.background = SceneOptions{}.background; // it knows no other
  line += typed_view(scene);
  const MethodOptions usual;
  if (view.smith != usual.smith) line += " --smith " + view.smith;
  if (view.multiscatter) line += " --multiscatter";
  if (command == "capture") {
    if (device.backend != DeviceOptions{}.backend) line += " --backend " + device.backend;
    if (view.method != usual.method) line += " --method " + view.method;
    if (!view.without.empty()) line += " --without " + in_shell(view.left_out());
    if (view.samples != usual.samples) line += fmt::format(" --samples {}", view.samples);
    if (view.exposure != 0.0f) line += fmt::format(" --exposure {}", view.exposure);
    if (view.tonemap != "neutral") line += " --tonemap " + view.tonemap;
  }
  return line;
}

viewer::Commands commands_of(const DeviceOptions& device) {
  viewer::Commands commands;
  commands.load_scene = [](const viewer::View& view) {
    SceneOptions o = options_of(view, 1, 1);
    o.materials = view.materials; // the edits come later, again and again
    scene::Scene scene = load_scene(o);
    for (const std::string& extension : scene::undrawn(scene))
      note(view.scene + ": " + extension
           + " is read and not drawn yet: its materials are drawn without it");
    return scene;
  };
  commands.load_environment = [](const viewer::View& view, const scene::Scene& scene) {
    return load_environment(options_of(view, 1, 1), scene);
  };
  commands.camera = [](const viewer::View& view, const scene::Scene& scene, int width, int height) {
    return choose_camera(options_of(view, width, height), scene, {width, height});
  };
  commands.background = [](const viewer::View& view) {
    return background_of(options_of(view, 1, 1));
  };
  commands.method = parse_method;
  for (const NamedMethod& method : methods())
    commands.methods.push_back(method.name);
  commands.words = [device](const std::string& command, const viewer::View& view, int width,
                            int height, const std::string& output) {
    return words(device, command, view, width, height, output);
  };
  return commands;
}

// The place that --eye and its kin give; nothing if they do not.
std::optional<viewer::Place> place_of(const SceneOptions& o) {
  if (o.eye.empty()) return std::nullopt;
  viewer::Place place{.eye = parse_vec3(o.eye, "--eye"),
                      .up = parse_vec3(o.up, "--up"),
                      .fovy = o.fovy.value_or(45.0f),
                      .ortho = o.ortho.value_or(0.0f)};
  if (o.target.empty())
    throw Error(ExitCode::usage, "--eye", "is given without --target",
                "Say what the camera turns about: --target X,Y,Z.");
  place.target = parse_vec3(o.target, "--target");
  return place;
}

// "X,Y", each from 0 to 1.
glm::vec2 parse_place(const std::string& text) {
  std::istringstream in(text);
  glm::vec2 at(-1.0f);
  char comma = 0;
  in >> at.x >> comma >> at.y;
  if (!in || comma != ',' || !in.eof() || glm::any(glm::lessThan(at, glm::vec2(0.0f)))
      || glm::any(glm::greaterThan(at, glm::vec2(1.0f))))
    throw Error(ExitCode::usage, "--inspect", "'" + text + "' is not understood",
                "Write two numbers from 0 to 1: --inspect 0.5,0.4.");
  return at;
}

viewer::DebugKind parse_debug(const std::string& text) {
  constexpr auto& names = viewer::debug_names;
  const auto found = std::ranges::find(names, text);
  if (found == std::end(names))
    throw Error(ExitCode::usage, "--debug-view", "'" + text + "' is not known",
                fmt::format("Choose one of: {}.", fmt::join(names, ", ")));
  return static_cast<viewer::DebugKind>(found - std::begin(names));
}

void check(const ViewOptions& o) {
  if (o.method.samples < 1 || o.method.samples > 4096)
    throw Error(ExitCode::usage, "--samples", "must be from 1 to 4096");
  if (!std::isfinite(o.exposure))
    throw Error(ExitCode::usage, "--exposure", "must be a finite number of stops");
  if (o.method.smith != "separable" && o.method.smith != "correlated")
    throw Error(ExitCode::usage, "--smith", "'" + o.method.smith + "' is not known",
                "Choose separable or correlated.");
  if (o.settings.bench_orbit < 0)
    throw Error(ExitCode::usage, "--bench-orbit", "must be 0 or more");
  if (!(o.settings.frames_per_second > 0.0))
    throw Error(ExitCode::usage, "--fps", "must be more than 0");
  if (!(o.scale >= 0.0f && o.scale <= 8.0f))
    throw Error(ExitCode::usage, "--scale", "must be from 0 to 8");
  frame::parse_tone_map(o.tonemap);
  parse_method(o.method.method);
  if (!o.settings.second.empty()) {
    find_method(o.settings.second, "--second");
    if (o.settings.truth > 0)
      throw Error(ExitCode::usage, "--second", "is given with --truth",
                  "Choose one: it stands in its place.");
  }
  needs::left_out(o.method.without);
  background_of(o.scene);
  if (!o.json.empty()) check_json(o.json);
  if (!o.settings.screenshot_window.empty()) OutputFile probe(o.settings.screenshot_window);
}

void view(ViewOptions o) {
  check(o);
  if (o.scene.scene.empty())
    o.scene.scene = (home_directory() / "assets/scenes/ball-grid.glb").string();
  const Size size = parse_size(o.scene.size);
  viewer::Settings settings = std::move(o.settings);
  settings.view = {.scene = o.scene.scene,
                   .time = o.scene.time,
                   .animation = o.scene.animation,
                   .materials = o.scene.materials,
                   .edits = {},
                   .env = o.scene.env,
                   .env_rotation = o.scene.env_rotation,
                   .env_intensity = o.scene.env_intensity,
                   .background = o.scene.background,
                   .camera = o.scene.camera,
                   .place = place_of(o.scene),
                   .method = o.method.method,
                   .smith = o.method.smith,
                   .multiscatter = o.method.multiscatter,
                   .without = needs::names_left_out(o.method.without),
                   .samples = o.method.samples,
                   .exposure = o.exposure,
                   .tonemap = o.tonemap};
  settings.panel = !o.no_panel;
  settings.standard_in_motion = !o.keep_method;
  if (!o.debug_view.empty()) settings.debug = parse_debug(o.debug_view);
  if (!o.inspect.empty()) settings.inspect = parse_place(o.inspect);
  const bool without_hands = settings.bench_orbit > 0;
  settings.window = {.title = "Groundglass",
                     .width = size.width,
                     .height = size.height,
                     .backend =
                         o.device.backend == "vulkan" ? gpu::Backend::vulkan : gpu::Backend::opengl,
                     .device = o.device.device.value_or(-1),
                     .wait_for_display = !without_hands,
                     .scale = o.scale};
  if (o.device.backend != "opengl" && o.device.backend != "vulkan" && o.device.backend != "auto")
    throw Error(ExitCode::usage, "--backend", "'" + o.device.backend + "' is not understood",
                "The backends are opengl, vulkan and auto.");
  if (o.device.backend == "auto") o.device.backend = "opengl";
  viewer::Commands commands = commands_of(o.device);
  commands.write_times = [path = o.json.empty() ? "-" : o.json](const nlohmann::json& times) {
    write_json(path, times);
  };
  viewer::run(settings, commands);
}

} // namespace

void add_view(Command program) {
  auto options = std::make_shared<ViewOptions>();
  options->scene.size = "1280x800";
  Command command =
      program.subcommand("view", "Look at a scene in a window, with its error beside it");
  command.option("SCENE", &options->scene.scene,
                 "A glTF 2.0 file, .gltf or .glb; without one, the demo");
  add_view_options(command, options->scene);
  add_background(command, options->scene);
  add_window_options(command, options->device);
  add_options(command, options->method);
  viewer::Settings& settings = options->settings;
  command.option("--exposure", &options->exposure, "Stops of brightness added");
  command.option("--tonemap", &options->tonemap, "none, neutral, aces or agx");
  command.option("--fps", &settings.frames_per_second,
                 "Frames a second to keep while something moves, by drawing smaller pictures");
  command.option("--scale", &options->scale, "Of text and controls; 0: the display's");
  command.flag("--keep-method", options->keep_method,
               "Draw by --method in motion too, where it misses half of --fps: else the camera "
               "moves by standard");
  command.flag("--no-panel", options->no_panel, "Begin without the panel (Tab shows it)");
  command.option("--bench-orbit", &settings.bench_orbit,
                 "Time so many frames of a turn about the scene, and end; see --json");
  command.option("--json", &options->json, "Write the times of --bench-orbit to this file");
  command.option("--screenshot-window", &settings.screenshot_window,
                 "Write the finished window to this .png, and end");
  command.option("--pick", &settings.pick,
                 "With --screenshot-window: pick the object of this name");
  command.option("--debug-view", &options->debug_view,
                 "In the picture's place: normals, depth, 'interior layers', 'path length inside', "
                 "'sigma in pixels', 'screen share' or "
                 "samples");
  command.option("--inspect", &options->inspect,
                 "Show the lobes at this place of the picture, X,Y from 0,0, its top left, to 1,1");
  command.option("--truth", &settings.truth, "Begin with the truth, of so many samples per pixel");
  command.option("--second", &settings.second,
                 "Begin with the picture of another method in the truth's place");
  command.option("--compare", &settings.comparing,
                 "How it is shown: wipe, side-by-side, error or flip");
  command.action([options] { view(*options); });
}

} // namespace gg::commands
