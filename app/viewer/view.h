// What is looked at and how, as a command line says it: the viewer keeps its state in these words, so that the line that it
// copies is exact.
#pragma once

#include "environment/map.h"
#include "frame/display.h"
#include "frame/frame_desc.h"
#include "needs/features.h"
#include "scene/scene.h"

#include <nlohmann/json_fwd.hpp>

#include <functional>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace gg::viewer {

// Where the camera is. Metres and degrees.
struct Place {
  glm::vec3 eye{0.0f, 0.0f, 3.0f}, target{0.0f}, up{0.0f, 1.0f, 0.0f};
  float fovy = 45.0f;
  float ortho =
      0.0f; // metres: the height of what an orthographic camera sees; 0: the camera is perspective
  bool operator==(const Place&) const = default;
};

// What a material is changed by: a preset, which may be empty, and settings, as --material has them.
struct Edit {
  std::string preset;
  std::vector<std::pair<std::string, std::string>> settings;
  bool empty() const { return preset.empty() && settings.empty(); }
  const std::string* find(const std::string& key) const;
  void set(const std::string& key, const std::string& value);
  void erase(const std::string& key);
  bool operator==(const Edit&) const = default;
};

struct View {
  std::string scene;
  std::optional<float> time; // seconds into the animation; nothing: as the nodes stand
  std::string animation;
  std::vector<std::string> materials; // --material as given, applied before the edits
  std::vector<Edit> edits;            // by material of the file; may be shorter
  std::string env;                    // a file, `none`, a colour, or empty: the default
  float env_rotation = 0.0f;          // degrees
  float env_intensity = 1.0f;
  std::string background = "sharp";
  std::string camera;         // of the file; used until the camera is moved
  std::optional<Place> place; // in place of the file's camera
  std::string method = "lobes2", smith = "separable";
  bool multiscatter = false;
  std::set<std::string> without; // features, as `groundglass needs` names them
  int samples = 16;
  float exposure = 0.0f; // EV
  std::string tonemap = "neutral";

  std::string left_out() const; // as --without takes them
  // The edits as --material options, after those that were given.
  std::vector<std::string> all_materials() const;
};

// What the command line does, done by whoever knows it. All throw Error.
struct Commands {
  std::function<scene::Scene(const View&)> load_scene; // with its materials as the view says
  std::function<std::optional<environment::Map>(const View&, const scene::Scene&)> load_environment;
  std::function<scene::Camera(const View&, const scene::Scene&, int width, int height)> camera;
  std::function<frame::Background(const View&)> background;
  std::function<needs::Method(const std::string&)> method;
  std::vector<std::string> methods;
  std::function<void(const nlohmann::json&)> write_times; // of --bench-orbit
  // The words that follow `groundglass COMMAND`, with `output` if it is not empty.
  std::function<std::string(const std::string& command, const View&, int width, int height,
                            const std::string& output)>
      words;
};

} // namespace gg::viewer
