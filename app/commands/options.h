// The options that say what is drawn and from where: the same for every command that draws.
#pragma once

#include "commands/command_line.h"
#include "environment/map.h"
#include "frame/frame_desc.h"
#include "gpu/device.h"
#include "needs/features.h"
#include "scene/load.h"
#include "scene/scene.h"

#include <cstdio>
#include <filesystem>
#include <initializer_list>
#include <optional>
#include <string>
#include <vector>

namespace gg::commands {

// As typed; the functions below turn them into things and complain about what does not exist.
struct SceneOptions {
  std::string scene;
  std::optional<float> time;          // seconds into the animation; nothing: as the nodes stand
  std::string animation;              // name or index; empty: the first, if a time is given
  std::vector<std::string> materials; // 'NAME=PRESET[,k=v]'
  std::string env;           // a file, a name, `none`, a colour "R,G,B", or empty: the default
  float env_rotation = 0.0f; // degrees
  float env_intensity = 1.0f;
  std::string background = "sharp"; // of commands that have add_background()
  std::string size = "1280x720";
  std::string camera; // name or index
  std::string eye, target, up = "0,1,0";
  std::optional<float> fovy;  // degrees
  std::optional<float> ortho; // metres: the height that an orthographic camera sees
};

struct DeviceOptions {
  std::string backend = "opengl", surface;
  std::optional<int> device; // any
};

struct MethodOptions {
  std::string method = "lobes2", smith = "separable";
  bool multiscatter = false;
  std::string without; // names of needs/left_out.h with commas between them
  int samples = 16;
  std::optional<double> budget, max_error; // ms; relMSE: of --method auto
};

void add_options(Command command, SceneOptions& options);
// The same without SCENE, for commands that take several scenes.
void add_view_options(Command command, SceneOptions& options);
void add_background(Command command, SceneOptions& options);
void add_options(Command command, DeviceOptions& options);
// The same for a window, which is its own surface.
void add_window_options(Command command, DeviceOptions& options);
void add_options(Command command, MethodOptions& options);
// --budget and --max-error, for the command that takes --method auto.
void add_automatic(Command command, MethodOptions& options);

// Everything that can be wrong with where the results go, before the work that makes them: throws Error(output) for a path
// that cannot be written, Error(usage) for two that are one. Empty paths do not count.
void probe_outputs(std::initializer_list<std::filesystem::path> paths);
// Where the text for people goes: not to standard output if a result ("-") goes there.
std::FILE* text_stream(std::initializer_list<std::filesystem::path> results);

struct Size {
  int width = 0, height = 0;
};
// "WxH", both from 1 to 16384. Throws Error(usage).
Size parse_size(const std::string& text);
// "X,Y,Z", finite. Throws Error(usage) naming the option.
glm::vec3 parse_vec3(const std::string& text, const std::string& option);

scene::Scene load_scene(const SceneOptions& options);
// The same of a file that is open.
scene::Scene load_scene(const SceneOptions& options, scene::File& file);
scene::Camera choose_camera(const SceneOptions& options, const scene::Scene& scene, Size size);
// Nothing if the scene is lit by its own lights alone.
std::optional<environment::Map> load_environment(const SceneOptions& options,
                                                 const scene::Scene& scene);
// Throws Error(usage) if it is not understood, or if there is no environment to replace.
frame::Background background_of(const SceneOptions& options);
// Which device the options name, before it is opened. Throws Error(usage) for names that do not exist.
gpu::DeviceDesc device_of(const DeviceOptions& options);
std::unique_ptr<gpu::Device> open_device(const DeviceOptions& options);

// What --env means: a file, or nothing for `none` and a colour.
std::optional<std::filesystem::path> environment_file(const SceneOptions& options);
// Whether the camera comes from the scene's bounds, which move with it, and not from the file or the options.
bool camera_is_framed(const SceneOptions& options, const scene::Scene& scene);
// The options that differ from their defaults, each after a space, as they would be typed in a shell.
std::string typed_view(const SceneOptions& options);
// A word as a shell reads it back.
std::string in_shell(const std::string& word);
// How this program was called.
std::string command_line();

struct NamedMethod {
  std::string name; // as --method takes it
  needs::Method method;
};
// All that a report compares if it is not told which.
const std::vector<NamedMethod>& methods();
// By name. Throws Error(usage) naming the option that it was given to.
NamedMethod find_method(const std::string& text, const std::string& option = "--method");
needs::Method parse_method(const std::string& text);

} // namespace gg::commands
