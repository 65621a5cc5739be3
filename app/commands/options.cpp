#include "commands/options.h"

#include "commands/environment_name.h"
#include "core/error.h"
#include "core/files.h"
#include "core/suggest.h"
#include "scene/apply.h"
#include "scene/framing.h"
#include "scene/load.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <fstream>

namespace gg::commands {
namespace {

// The largest picture side: what OpenGL 4.5 and Vulkan 1.3 drivers in use offer as a texture.
constexpr int largest_side = 16384;

[[noreturn]] void refuse(const std::string& option, const std::string& text,
                         const std::string& remedy) {
  throw Error(ExitCode::usage, option, "'" + text + "' is not understood", remedy);
}

// The numbers of "a<separator>b<separator>c", all of the text, or nothing.
template <class T>
std::optional<std::vector<T>> parse_numbers(const std::string& text, char separator) {
  std::vector<T> numbers;
  const char* at = text.data();
  const char* const end = at + text.size();
  while (true) {
    T value{};
    const auto [after, error] = std::from_chars(at, end, value);
    if (error != std::errc{}) return std::nullopt;
    numbers.push_back(value);
    if (after == end) return numbers;
    if (*after != separator) return std::nullopt;
    at = after + 1;
  }
}

std::optional<glm::vec3> as_vec3(const std::string& text) {
  const auto numbers = parse_numbers<float>(text, ',');
  if (!numbers || numbers->size() != 3) return std::nullopt;
  const glm::vec3 v((*numbers)[0], (*numbers)[1], (*numbers)[2]);
  if (!std::isfinite(v.x) || !std::isfinite(v.y) || !std::isfinite(v.z)) return std::nullopt;
  return v;
}

} // namespace

void add_options(Command command, SceneOptions& o) {
  command.option("SCENE", &o.scene, "A glTF 2.0 file, .gltf or .glb; - for standard input")
      .required();
  add_view_options(command, o);
}

void add_view_options(Command command, SceneOptions& o) {
  command.option("--material", &o.materials,
                 "NAME=PRESET[,key=value...], * for every material; may be repeated");
  command.option("--time", &o.time, "Pose the scene as its animation has it, so many seconds in");
  command.option("--animation", &o.animation,
                 "The animation that --time is of, by name or index (the first if not given)");
  command.option(
      "--env", &o.env,
      "Environment: an equirectangular .hdr or .exr, a name (see list), a colour R,G,B, or none "
      "(royal_esplanade if not given)");
  command.option("--env-rotation", &o.env_rotation,
                 "Degrees about +Y, counter-clockwise seen from above");
  command.option("--env-intensity", &o.env_intensity, "Factor on the environment's radiance");
  command.option("--size", &o.size, "Width x height in pixels");
  command.option(
      "--camera", &o.camera,
      "A camera of the file, by name or index (its first if not given, or one that shows all)");
  command.option("--eye", &o.eye, "A camera at this place: X,Y,Z in metres");
  command.option("--target", &o.target,
                 "With --eye: what it looks at, X,Y,Z (the scene's centre if not given)");
  command.option("--up", &o.up, "With --eye: which way is up, X,Y,Z");
  command.option("--fovy", &o.fovy,
                 "Vertical field of view in degrees (45, or the camera's own, if not given)");
  command.option("--ortho", &o.ortho,
                 "With --eye: an orthographic camera that sees so many metres from top to bottom");
}

void add_background(Command command, SceneOptions& o) {
  command.option(
      "--background", &o.background,
      "What is behind everything: sharp, the environment itself; blurred; or a colour R,G,B");
}

void add_options(Command command, DeviceOptions& o) {
  add_window_options(command, o);
  command.option(
      "--surface", &o.surface,
      "What OpenGL draws with when there is no window: egl or osmesa (the first that works)");
}

void add_window_options(Command command, DeviceOptions& o) {
  command.option("--backend", &o.backend, "opengl, vulkan, or auto: the first that works");
  command.option("--device", &o.device, "Index from `groundglass devices`");
}

void add_options(Command command, MethodOptions& o) {
  command.option("--method", &o.method,
                 "How glass and metal are drawn: a name that `groundglass list methods` prints");
  command.option("--samples", &o.samples, "Samples per pixel, averaged: antialiasing");
  command.option("--smith", &o.smith, "Shadowing: separable (Walter 2007) or correlated");
  command.flag("--multiscatter", o.multiscatter, "Give back the energy of multiple scattering");
  command.option(
      "--without", &o.without,
      "Draw without features, named as `needs` names them: 'normal map,dispersion,neighbours'");
}

void add_automatic(Command command, MethodOptions& o) {
  command.option("--budget", &o.budget,
                 "With --method auto, which measures all methods on the scene: take the most "
                 "accurate within so many ms for a frame of one sample per pixel");
  command.option("--max-error", &o.max_error,
                 "With --method auto: take the fastest whose relMSE over the objects is no larger");
}

Size parse_size(const std::string& text) {
  const auto numbers = parse_numbers<int>(text, 'x');
  if (!numbers || numbers->size() != 2)
    refuse("--size", text, "Write width x height in pixels: --size 1280x720.");
  for (const int side : *numbers)
    if (side < 1 || side > largest_side)
      refuse("--size", text,
             "Each side goes from 1 to " + std::to_string(largest_side) + " pixels.");
  return {(*numbers)[0], (*numbers)[1]};
}

glm::vec3 parse_vec3(const std::string& text, const std::string& option) {
  const auto v = as_vec3(text);
  if (!v) refuse(option, text, "Write three numbers: " + option + " 1,2,3.");
  return *v;
}

scene::Scene load_scene(const SceneOptions& options) {
  scene::File file(options.scene);
  return load_scene(options, file);
}

scene::Scene load_scene(const SceneOptions& options, scene::File& file) {
  if (options.time && !std::isfinite(*options.time))
    refuse("--time", fmt::to_string(*options.time), "It is a time in seconds.");
  std::optional<scene::Instant> instant;
  if (options.time || !options.animation.empty())
    instant = {.time = options.time.value_or(0.0f), .animation = options.animation};
  scene::Scene scene = file.at(instant);
  for (const std::string& material : options.materials)
    scene::apply_material(scene, material);
  return scene;
}

scene::Camera choose_camera(const SceneOptions& options, const scene::Scene& scene, Size size) {
  constexpr float radians = 0.01745329252f;
  if (options.fovy && !(*options.fovy > 0.0f && *options.fovy < 180.0f))
    refuse("--fovy", fmt::to_string(*options.fovy),
           "The angle is more than 0 and less than 180 degrees.");
  if (!options.camera.empty() && !options.eye.empty())
    throw Error(ExitCode::usage, "--camera", "and --eye are both given", "Choose one.");
  if (!options.eye.empty()) {
    const glm::vec3 target = options.target.empty()
                                 ? scene.bounds.empty() ? glm::vec3(0.0f) : scene.bounds.centre()
                                 : parse_vec3(options.target, "--target");
    scene::Camera camera =
        scene::look_at(scene, parse_vec3(options.eye, "--eye"), target,
                       parse_vec3(options.up, "--up"), options.fovy.value_or(45.0f) * radians);
    if (!options.ortho) return camera;
    if (!(*options.ortho > 0.0f) || !std::isfinite(*options.ortho))
      refuse("--ortho", fmt::to_string(*options.ortho), "It is a height in metres, more than 0.");
    const float half = 0.5f * *options.ortho;
    camera.orthographic = true;
    camera.magnification = {half * static_cast<float>(size.width) / static_cast<float>(size.height),
                            half};
    scene::fit_depth(camera, scene);
    return camera;
  }
  if (options.ortho)
    throw Error(ExitCode::usage, "--ortho", "is given without --eye",
                "Say where the camera is: --eye X,Y,Z.");
  if (!options.target.empty())
    throw Error(ExitCode::usage, "--target", "is given without --eye",
                "Say where the camera is: --eye X,Y,Z.");
  scene::Camera camera = !options.camera.empty() ? scene::find_camera(scene, options.camera)
                         : !scene.cameras.empty()
                             ? scene::usable_camera(scene.cameras.front())
                             : scene::default_camera(scene, static_cast<float>(size.width)
                                                                / static_cast<float>(size.height));
  if (options.fovy) camera.fovy = *options.fovy * radians;
  return camera;
}

bool camera_is_framed(const SceneOptions& options, const scene::Scene& scene) {
  return options.eye.empty() ? options.camera.empty() && scene.cameras.empty()
                             : options.target.empty();
}

std::optional<environment::Map> load_environment(const SceneOptions& options,
                                                 const scene::Scene& scene) {
  if (!(options.env_intensity >= 0.0f) || !std::isfinite(options.env_intensity))
    refuse("--env-intensity", fmt::to_string(options.env_intensity), "It is a factor, 0 or more.");
  if (!std::isfinite(options.env_rotation))
    refuse("--env-rotation", fmt::to_string(options.env_rotation), "It is an angle in degrees.");
  if (options.env == "none") {
    if (scene.lights.empty())
      note(options.scene + ": has no lights and --env is none: only what emits light is seen");
    return std::nullopt;
  }
  if (const auto color = as_vec3(options.env)) {
    if (color->x < 0.0f || color->y < 0.0f || color->z < 0.0f)
      refuse("--env", options.env, "Radiance is not negative.");
    return environment::constant(*color);
  }
  return environment::load(*environment_file(options));
}

frame::Background background_of(const SceneOptions& o) {
  // Of the Gaussian that blurs it: what is smaller than some ten degrees is gone.
  constexpr float blurred = 0.15f;
  if (o.background == "sharp") return {};
  if (o.env == "none")
    throw Error(ExitCode::usage, "--background", "is given with --env none",
                "It takes the environment's place: leave one of them out.");
  if (o.background == "blurred") return {.sigma = blurred, .plain = {}};
  const auto color = as_vec3(o.background);
  if (!color)
    refuse("--background", o.background, "Write sharp, blurred, or a colour: 0.2,0.2,0.2.");
  if (glm::any(glm::lessThan(*color, glm::vec3(0.0f))))
    refuse("--background", o.background, "Radiance is not negative.");
  return {.sigma = 0.0f, .plain = color};
}

std::optional<std::filesystem::path> environment_file(const SceneOptions& options) {
  if (options.env == "none" || as_vec3(options.env)) return std::nullopt;
  return find_environment(options.env.empty() ? "royal_esplanade" : options.env);
}

void probe_outputs(std::initializer_list<std::filesystem::path> paths) {
  refuse_same_output(paths);
  for (const std::filesystem::path& path : paths)
    if (!path.empty()) OutputFile probe(path);
}

std::FILE* text_stream(std::initializer_list<std::filesystem::path> results) {
  for (const std::filesystem::path& path : results)
    if (!path.empty() && destination_of(path).descriptor == 1) return stderr;
  return stdout;
}

std::string in_shell(const std::string& word) {
  constexpr const char* plain =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-+=.,:/@%";
  if (!word.empty() && word.find_first_not_of(plain) == std::string::npos) return word;
  std::string quoted = "'";
  for (const char ch : word)
    quoted += ch == '\'' ? std::string("'\\''") : std::string(1, ch);
  return quoted + "'";
}

std::string command_line() {
  std::string line;
  std::ifstream in("/proc/self/cmdline", std::ios::binary); // words that end with a zero each
  for (std::string word; std::getline(in, word, '\0');)
    line += line.empty() ? std::filesystem::path(word).filename().string() : " " + in_shell(word);
  return line;
}

std::string typed_view(const SceneOptions& o) {
  const SceneOptions defaults;
  std::string line;
  const auto add = [&](const char* option, const std::string& value, const std::string& usual) {
    if (value != usual) line += std::string(" ") + option + " " + in_shell(value);
  };
  if (o.time) add("--time", fmt::format("{}", *o.time), "");
  add("--animation", o.animation, "");
  for (const std::string& material : o.materials)
    add("--material", material, "");
  add("--env", o.env, defaults.env);
  add("--env-rotation", fmt::format("{}", o.env_rotation), "0");
  add("--env-intensity", fmt::format("{}", o.env_intensity), "1");
  add("--background", o.background, defaults.background);
  add("--size", o.size, defaults.size);
  add("--camera", o.camera, defaults.camera);
  add("--eye", o.eye, defaults.eye);
  add("--target", o.target, defaults.target);
  add("--up", o.up, defaults.up);
  if (o.fovy) add("--fovy", fmt::format("{}", *o.fovy), "");
  if (o.ortho) add("--ortho", fmt::format("{}", *o.ortho), "");
  return line;
}

gpu::DeviceDesc device_of(const DeviceOptions& options) {
  gpu::DeviceDesc desc{.device = options.device.value_or(-1)};
  if (options.surface == "egl")
    desc.surface = gpu::Surface::egl;
  else if (options.surface == "osmesa")
    desc.surface = gpu::Surface::osmesa;
  else if (!options.surface.empty())
    refuse("--surface", options.surface, "The surfaces are egl and osmesa.");
  if (options.backend == "opengl")
    desc.backend = gpu::Backend::opengl;
  else if (options.backend == "vulkan")
    desc.backend = gpu::Backend::vulkan;
  else if (options.backend != "auto")
    refuse("--backend", options.backend, "The backends are opengl, vulkan and auto.");
  if (desc.backend == gpu::Backend::vulkan && !options.surface.empty())
    throw Error(ExitCode::usage, "--surface", "is of OpenGL alone",
                "Leave it out with --backend vulkan.");
  return desc;
}

std::unique_ptr<gpu::Device> open_device(const DeviceOptions& options) {
  gpu::DeviceDesc desc = device_of(options);
  if (options.backend != "auto") return gpu::create_device(desc);
  try {
    desc.backend = gpu::Backend::vulkan;
    return gpu::create_device(desc);
  } catch (const Error& error) {
    note(std::string(error.what()) + " Falling back to OpenGL.");
    desc.backend = gpu::Backend::opengl;
    return gpu::create_device(desc);
  }
}

const std::vector<NamedMethod>& methods() {
  static const std::vector<NamedMethod> all = {
      {"standard", needs::Method::standard}, {"lobes1", needs::Method::lobes1},
      {"lobes2", needs::Method::lobes2},     {"lobes3", needs::Method::lobes3},
      {"lobes4", needs::Method::lobes4},     {"fis16", needs::fis(16)}};
  return all;
}

NamedMethod find_method(const std::string& text, const std::string& option) {
  std::vector<std::string> names;
  for (const NamedMethod& method : methods()) {
    if (method.name == text) return method;
    names.push_back(method.name);
  }
  // Any number of importance samples; more than a thousand a pixel are the path tracer's business.
  constexpr int most_samples = 1024;
  int samples = 0;
  if (text.starts_with("fis")) {
    const char *first = text.data() + 3, *last = text.data() + text.size();
    const auto [end, error] = std::from_chars(first, last, samples);
    if (error == std::errc() && end == last && samples >= 1 && samples <= most_samples)
      return {text, needs::fis(samples)};
  }
  refuse(
      option, text,
      did_you_mean(text, names)
          + fmt::format("The methods are {}, fis1 to fis{}", fmt::join(names, ", "), most_samples)
          + (option == "--method" ? ", and for capture auto." : "."));
}

needs::Method parse_method(const std::string& text) {
  return find_method(text, "--method").method;
}

} // namespace gg::commands
