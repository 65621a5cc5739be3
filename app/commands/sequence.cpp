#include "commands/sequence.h"

#include "commands/json_file.h"
#include "core/error.h"
#include "core/files.h"
#include "image/image.h"
#include "report/key.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace gg::commands {
namespace {

constexpr double most_frames = 1e6; // what six digits number

std::string key_of(const Sequence& sequence, const SceneOptions& scene,
                   const std::string& drawing) {
  SceneOptions options = scene;
  options.env.clear(); // by its contents
  options.time.reset();
  const auto file = environment_file(scene);
  return report::Key()
      .add(report::key_of_gltf(scene.scene))
      .add(file ? report::key_of_file(*file) : scene.env)
      .add(typed_view(options))
      .add(drawing)
      .add(sequence.fps)
      .add(sequence.from)
      .text();
}

} // namespace

void add_options(Command command, Sequence& s) {
  command.option("--frames-out", &s.directory,
                 "Draw the animation into this folder, a numbered picture each, instead of -o; "
                 "those that are there are kept");
  command.option("--fps", &s.fps, "With --frames-out: frames a second of the animation");
  command.option("--from", &s.from, "With --frames-out: the first frame's time, in seconds");
  command.option("--to", &s.to,
                 "With --frames-out: the last time; without it, the animation's end");
  command.option("--format", &s.format, "With --frames-out: png, jpg, exr, hdr or pfm");
}

void check_sequence(const Sequence& s, const SceneOptions& scene) {
  const auto reject = [](const char* option, const std::string& what, const char* remedy) {
    throw Error(ExitCode::usage, option, what, remedy);
  };
  if (scene.time)
    reject("--time", "is given with --frames-out", "A sequence goes --from one time --to another.");
  if (scene.scene == "-")
    reject("SCENE", "is standard input, and a sequence reads it again and again", "Name a file.");
  if (!(s.fps > 0.0f) || !std::isfinite(s.fps)) reject("--fps", "must be more than 0", "");
  if (!std::isfinite(s.from)) reject("--from", "is not a time in seconds", "");
  if (s.to && !(std::isfinite(*s.to) && *s.to >= s.from))
    reject("--to", "is before --from", "It is a time in seconds, that of --from or later.");
  if (s.format == "." || !image::is_writable_extension("frame." + s.format))
    reject("--format", "'" + s.format + "' is not known", "Choose png, jpg, exr, hdr or pfm.");
}

std::vector<SequenceFrame> frames_of(const Sequence& s, const scene::Posed& posed) {
  const double from = s.from, to = std::max(from, double{s.to.value_or(posed.end)});
  // The last frame may miss the end by rounding: times are 32-bit.
  constexpr double rounding = 1e-4;
  const double last = std::floor((to - from) * s.fps + rounding);
  if (last >= most_frames)
    throw Error(ExitCode::usage, "--frames-out", fmt::format("asks for {:.0f} frames", last + 1.0),
                "A sequence has at most a million: lower --fps or --to.");
  std::vector<SequenceFrame> frames;
  for (int i = 0; i <= static_cast<int>(last); ++i)
    frames.push_back(
        {static_cast<float>(from + i / double{s.fps}),
         std::filesystem::path(s.directory) / fmt::format("frame-{:06}.{}", i, s.format)});
  return frames;
}

void begin_sequence(const Sequence& s, const SceneOptions& scene, const std::string& drawing) {
  const std::filesystem::path list = std::filesystem::path(s.directory) / "sequence.json";
  const std::string key = key_of(s, scene, drawing);
  if (std::filesystem::exists(list)) {
    const auto json = nlohmann::json::parse(read_text(list), nullptr, false);
    if (json.is_object() && json.value("key", nlohmann::json()) == key) return;
    throw Error(ExitCode::usage, s.directory, "holds the frames of another sequence",
                "Choose another folder, or remove it: its scene, options or rate are not these.");
  }
  write_json(list, {{"key", key},
                    {"scene", scene.scene},
                    {"options", typed_view(scene)},
                    {"fps", s.fps},
                    {"from", s.from}});
}

bool only_moved(const scene::Scene& a, const scene::Scene& b) {
  const auto same = [](const auto& x, const auto& y, auto equal) {
    return std::equal(x.begin(), x.end(), y.begin(), y.end(), equal);
  };
  return a.indices == b.indices && a.lights.size() == b.lights.size()
         && same(a.streams, b.streams,
                 [](const scene::Stream& x, const scene::Stream& y) {
                   return x.components == y.components && x.values == y.values;
                 })
         && same(a.instances, b.instances, [](const scene::Instance& x, const scene::Instance& y) {
              return x.mesh == y.mesh;
            });
}

} // namespace gg::commands
