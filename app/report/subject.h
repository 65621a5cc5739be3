// What a report is about, as the command line gives it: scenes, methods, devices.
#pragma once

#include "environment/map.h"
#include "frame/renderer.h"
#include "gpu/device.h"
#include "report/choice.h"
#include "scene/scene.h"

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace gg::report {

// A scene as it is drawn. Shared by all methods; outlives what is made from it.
struct Loaded {
  scene::Scene scene;
  scene::Camera camera;
  std::optional<environment::Map> environment;
  float rotation = 0.0f;  // radians
  float intensity = 1.0f; // factor
};

// Loading is put off until something has to be drawn, so that a report whose results are all cached
// costs nothing.
struct Subject {
  std::string name; // short, of one report unlike any other
  std::string path;
  std::string environment; // for people
  std::string key;         // of everything that the picture depends on, size included
  int width = 0, height = 0;
  std::function<std::unique_ptr<Loaded>()> load;
  // What the scene needs of the frame, a line each; may be empty.
  std::function<std::vector<std::string>(const Loaded&)> needs;
  std::string options; // of `groundglass capture` and `truth`, scene included, to see it again
};

struct Method {
  std::string name; // as --method takes it
  needs::Method method{};
};

struct Plan {
  std::vector<Subject> subjects;
  std::vector<Method> methods;
  // Each is opened at most once, when it is needed. The text is how --backend names it.
  std::vector<std::pair<std::string, std::function<std::unique_ptr<gpu::Device>()>>> devices;
  bool correlated_smith = false, multiple_scattering = false;
  std::vector<int> samples = {1, 4, 16}; // per pixel: a picture of each by every method
  int pictures = 20;                     // to be timed, of each
  long truth_samples = 256;
  double truth_error = 0.0; // not 0: goes on until it is reached, whatever the samples
  Limit limit;
  std::filesystem::path directory;
  std::string version, command;
};

} // namespace gg::report
