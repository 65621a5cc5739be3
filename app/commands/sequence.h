// Pictures of an animation, numbered.
#pragma once

#include "commands/options.h"

#include <filesystem>
#include <string>
#include <vector>

namespace gg::commands {

struct Sequence {
  std::string directory; // empty: no sequence is asked for
  float fps = 24.0f, from = 0.0f;
  std::optional<float> to; // seconds; nothing: the animation's end
  std::string format = "png";
};

void add_options(Command command, Sequence& sequence);

struct SequenceFrame {
  float time = 0.0f; // seconds
  std::filesystem::path path;
};

// Throws Error(usage) for what cannot be meant.
void check_sequence(const Sequence& sequence, const SceneOptions& scene);
// frame-000000.png at `from`, and so on, 1 / fps apart, up to `to` inclusive: at least one, at most a million. Throws
// Error(usage) for more.
std::vector<SequenceFrame> frames_of(const Sequence& sequence, const scene::Posed& posed);
// Makes the directory and says in its sequence.json what its frames are of: the scene, its options, and `drawing`, which
// names the rest. Frames that are there are kept, so that a sequence goes on where it was broken off. Throws
// Error(usage) if the directory holds those of another one, Error(output) if it cannot be written.
void begin_sequence(const Sequence& sequence, const SceneOptions& scene,
                    const std::string& drawing);

// Whether two poses of one file differ in nothing but where its meshes, lights and cameras stand.
bool only_moved(const scene::Scene& a, const scene::Scene& b);

} // namespace gg::commands
