// The vocabulary of app/gpu: what a buffer, a texture, a pipeline and a pass are, in no API's
// words.
//
// Conventions that every backend keeps:
//   clip space   x right, y up, z in 0..1; reversed depth is the caller's choice of projection and
//                compare
//   pictures     row 0 is the top; texture coordinate (0, 0) is the corner of its first texel
//   front faces  counter-clockwise as seen
//   cubes        faces +X -X +Y -Y +Z -Z as OpenGL and Vulkan define them, filtered across edges
//   block offset a uniform or storage block starts at a multiple of block_alignment
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace gg::gpu {

enum class Format {
  none,
  r8,
  rg8,
  rgba8,
  rgba8_srgb,
  r16f,
  rg16f,
  rgba16f,
  r32f,
  rg32f,
  rgba32f,
  r32ui,
  rg32ui,
  rgba32ui,
  depth32f
};
std::size_t bytes_per_texel(Format format);

// What a buffer or a texture may be used for; combined with |.
enum class Use : unsigned {
  vertices = 1u << 0,
  indices = 1u << 1,
  uniforms = 1u << 2,
  storage = 1u << 3,    // read and written by shaders
  sampled = 1u << 4,    // texture()
  attachment = 1u << 5, // drawn into
  read_back = 1u << 6,  // copied to the host
};
constexpr Use operator|(Use a, Use b) {
  return static_cast<Use>(static_cast<unsigned>(a) | static_cast<unsigned>(b));
}
constexpr bool has(Use set, Use one) {
  return (static_cast<unsigned>(set) & static_cast<unsigned>(one)) != 0;
}

struct BufferDesc {
  std::string label;
  std::size_t bytes = 0;
  Use use = Use::storage;
};

enum class Shape { d2, d2_array, d3, cube, cube_array };

struct TextureDesc {
  std::string label;
  Shape shape = Shape::d2;
  Format format = Format::rgba8;
  int width = 1, height = 1;
  int layers = 1; // slices of an array or of a volume; a cube has 6 faces without being told
  int levels = 1;
  Use use = Use::sampled;
};

// The size of one level; `layers` counts faces of cubes and, at that level, slices of volumes.
struct Extent {
  int width = 1, height = 1, layers = 1;
};
Extent extent(const TextureDesc& desc, int level);
int max_levels(const TextureDesc& desc);    // of a complete mip chain
std::size_t bytes(const TextureDesc& desc); // of all levels and layers

// What every OpenGL 4.5 and Vulkan 1.3 device accepts as the offset of a block.
constexpr std::size_t block_alignment = 256;

enum class Filter { nearest, linear };
enum class Wrap { repeat, mirrored_repeat, clamp };

struct SamplerDesc {
  Filter magnify = Filter::linear, minify = Filter::linear, between_levels = Filter::nearest;
  Wrap u = Wrap::clamp, v = Wrap::clamp, w = Wrap::clamp;
  float max_anisotropy = 1.0f;
  float max_level = 1000.0f; // 0: never reads a smaller level
  bool operator==(const SamplerDesc&) const = default;
};

// Objects are shared and die with their last owner; backends derive from them.
struct Buffer {
  BufferDesc desc;
  virtual ~Buffer() = default;
};
struct Texture {
  TextureDesc desc;
  virtual ~Texture() = default;
};
struct Sampler {
  SamplerDesc desc;
  virtual ~Sampler() = default;
};
using BufferRef = std::shared_ptr<Buffer>;
using TextureRef = std::shared_ptr<Texture>;
using SamplerRef = std::shared_ptr<Sampler>;

enum class Compare { never, less, equal, less_equal, greater, greater_equal, always };
enum class Cull { none, back, front };
enum class Blend {
  none,
  over, // premultiplied: source + (1 - source.a) destination
  add
};
enum class Step { vertex, instance };

struct Attribute {
  int location = 0;
  int components = 3; // floats
  int binding = 0;    // which vertices() slot
  std::uint32_t offset = 0;
};
struct VertexBinding {
  std::uint32_t stride = 0; // bytes; 0 repeats one value for every vertex
  Step step = Step::vertex;
};

// A specialization constant: `layout(constant_id = id)`. Bits of a bool, int, uint or float.
struct Constant {
  std::uint32_t id = 0;
  std::uint32_t bits = 0;
};
Constant constant(std::uint32_t id, bool value);
Constant constant(std::uint32_t id, std::int32_t value);
Constant constant(std::uint32_t id, std::uint32_t value);
Constant constant(std::uint32_t id, float value);

// Triangles from a vertex and a fragment stage of shaders/stages/ ("opaque.vert").
struct PipelineDesc {
  std::string label;
  std::string vertex, fragment;
  std::vector<Constant> constants; // given to both stages
  std::vector<VertexBinding> bindings;
  std::vector<Attribute> attributes;
  std::vector<Format> colors; // of the attachments it draws into
  Format depth = Format::none;
  bool depth_write = true;
  Compare depth_compare = Compare::greater_equal; // reversed depth: nearer is larger
  Cull cull = Cull::back;
  Blend blend = Blend::none;
};

struct ComputeDesc {
  std::string label;
  std::string compute; // "stack.comp"
  std::vector<Constant> constants;
};

// A compiled pipeline, drawing or computing.
struct Pipeline {
  std::string label;
  virtual ~Pipeline() = default;
};
using PipelineRef = std::shared_ptr<Pipeline>;

// A part of a texture.
struct View {
  TextureRef texture;
  int level = 0, level_count = 1;
  int layer = 0, layer_count = 1; // of a cube: its faces
};
// The whole of it.
View whole(const TextureRef& texture);

struct ColorTarget {
  View view;                                 // one level, one layer
  std::optional<std::array<float, 4>> clear; // else what was there is kept
};
struct DepthTarget {
  View view;
  std::optional<float> clear;
};

} // namespace gg::gpu
