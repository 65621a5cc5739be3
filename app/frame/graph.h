// The frame graph: passes, each declared with what it reads and writes. From these follow the textures, how long each is
// needed, and which of them can share memory. Pure: declared without a device, carried out by Renderer.
#pragma once

#include "gpu/types.h"

#include <array>
#include <cstddef>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace gg::gpu {
class Encoder;
}
namespace gg::frame {

struct Context; // frame/context.h

// A texture that passes draw into.
struct Target {
  std::string name;
  gpu::Format format = gpu::Format::rgba32f;
  int width = 0, height = 0; // pixels: a pass runs at the rate of the target that it draws into
  int layers = 1, levels = 1;
  bool array = false;     // is read as one, whatever its layers
  bool is_result = false; // lives through the whole frame, and can be read back
};
std::size_t bytes_of(const Target& target);

// A level and a layer of a target, or all of them.
struct Part {
  static constexpr int all = -1;
  std::size_t target = 0;
  int level = all, layer = all;
  bool operator==(const Part&) const = default;
};

// A target of earlier passes that a pass reads, under the name that its shaders give it.
struct Input {
  const char* name;
  Part part;
  gpu::Filter filter = gpu::Filter::nearest;
};

struct ColorOutput {
  Part part;                                 // one level and layer of it is drawn into
  std::optional<std::array<float, 4>> clear; // else what was there is kept
  bool accumulates = false;                  // cleared before the first sample alone
};

struct DepthOutput {
  std::size_t target = 0;
  std::optional<float> clear;
  int layer = 0;
};

using Record = std::function<void(gpu::Encoder&)>;

struct Pass {
  std::string label;     // of its timer; passes of one label are counted together
  std::size_t draws = 0; // of meshes and regions
  bool shades = false;   // materials: reads the environment, tables and textures
  bool once = false; // with the first sample of a frame: what it writes must live through the frame
  std::vector<Input> reads;
  std::vector<ColorOutput> colors;
  std::optional<DepthOutput> depth;
  // With a device: makes the pipelines and returns what draws a sample; inputs, and the blocks that all draws share, are bound by
  // then. Called twice, as pipelines are first only announced (Draws::expect).
  std::function<Record(Context&)> prepare;
};

struct Graph {
  int width = 0, height = 0; // of the picture
  std::vector<Target> targets;
  std::vector<Pass> passes; // of one sample, in order

  // The target of that name, declared at its first mention; the picture's size unless `desc` says otherwise.
  std::size_t target(Target desc);
  const Target* find(const std::string& name) const; // null: no pass draws into such a target
  bool is_written(std::size_t target) const;         // by a pass declared so far
};

// "screen pyramid 2", "interior 1", or the target's name where it is meant as a whole.
std::string name_of(const Graph& graph, const Part& part);

// The texture that each target is kept in: targets of one format and size share one if no pass comes between the first
// and the last use of both.
struct Allocation {
  std::vector<std::size_t> texture_of; // by target: which texture
  std::vector<std::size_t> first;      // by texture: a target that it is made for
  std::size_t bytes = 0;
};
Allocation allocate(const Graph& graph);

} // namespace gg::frame
