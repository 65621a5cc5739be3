#include "viewer/debug_view.h"

#include "image/heat_map.h"
#include "needs/features.h"
#include "uniforms/camera.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace gg::viewer {
namespace {

struct DrawBlock { // shaders/stages/debug_view.vert
  glm::mat4 clip_from_mesh, world_from_mesh, normal_from_mesh;
  glm::vec4 eye;
};
static_assert(sizeof(DrawBlock) == 208);

struct Call {
  const scene::Instance* instance;
  const scene::Primitive* primitive;
  const scene::Material* material;
};

std::vector<Call> calls_of(const scene::Scene& scene, bool solids_alone) {
  std::vector<Call> calls;
  for (const scene::Instance& instance : scene.instances)
    for (const scene::Primitive& primitive :
         scene.meshes[static_cast<std::size_t>(instance.mesh)].primitives) {
      const scene::Material& material =
          scene.materials[static_cast<std::size_t>(primitive.material)];
      const bool solid = needs::is_refractive(material) && material.thickness > 0.0f;
      if (scene.indices[static_cast<std::size_t>(primitive.indices)].empty()) continue;
      if (solid || !solids_alone) calls.push_back({&instance, &primitive, &material});
    }
  return calls;
}

std::vector<std::byte> blocks_of(const std::vector<Call>& calls, const scene::Camera& camera,
                                 double aspect) {
  std::vector<std::byte> bytes(gpu::block_alignment * std::max<std::size_t>(calls.size(), 1));
  const glm::dmat4 clip =
      uniforms::clip_from_view(camera, aspect) * uniforms::view_from_world(camera);
  for (std::size_t i = 0; i < calls.size(); ++i) {
    const glm::dmat4 world(calls[i].instance->world);
    const DrawBlock block{glm::mat4(clip * world), glm::mat4(world),
                          glm::mat4(glm::transpose(glm::inverse(world))), camera.world[3]};
    std::memcpy(&bytes[i * gpu::block_alignment], &block, sizeof block);
  }
  return bytes;
}

void put(image::Image& colours, std::size_t pixel, const std::array<float, 3>& colour) {
  std::ranges::copy(colour, colours.values.begin() + static_cast<std::ptrdiff_t>(3 * pixel));
}

// `values`: RGBA of every pixel, as debug_view.frag leaves them.
DebugView::Drawn coloured(DebugKind kind, const std::vector<float>& values, int width, int height) {
  DebugView::Drawn drawn{.colours = image::Image(width, height, 3)};
  const std::size_t pixels = values.size() / 4;
  const auto value = [&](std::size_t i) -> double {
    const float* v = &values[4 * i];
    if (kind == DebugKind::depth) return static_cast<double>(v[3]);
    return kind == DebugKind::interior_layers ? 0.5 * static_cast<double>(v[1])
                                              : std::max(static_cast<double>(v[0]), 0.0);
  };
  if (kind == DebugKind::normals) {
    drawn.greatest = 1.0;
    for (std::size_t i = 0; i < pixels; ++i)
      if (const float* v = &values[4 * i]; v[3] > 0.0f)
        put(drawn.colours, i, {0.5f + 0.5f * v[0], 0.5f + 0.5f * v[1], 0.5f + 0.5f * v[2]});
    return drawn;
  }
  for (std::size_t i = 0; i < pixels; ++i)
    drawn.greatest = std::max(drawn.greatest, value(i));
  if (!(drawn.greatest > 0.0)) return drawn;
  for (std::size_t i = 0; i < pixels; ++i)
    if (const double part = value(i) / drawn.greatest; part > 0.0)
      put(drawn.colours, i, image::heat_colour(part));
  return drawn;
}

} // namespace

const DebugView::Mesh& DebugView::mesh(const scene::Scene& scene,
                                       const scene::Primitive& primitive) {
  const auto [at, is_new] = meshes_.try_emplace(&primitive);
  Mesh& made = at->second;
  if (!is_new) return made;
  const auto stream = [&](scene::Index i, const char* label) {
    const auto& values = scene.streams[static_cast<std::size_t>(i)].values;
    return device_.create(gpu::BufferDesc{label, values.size() * sizeof(float), gpu::Use::vertices},
                          std::as_bytes(std::span(values)));
  };
  made.positions = stream(primitive.positions, "debug positions");
  made.normals = stream(primitive.normals, "debug normals");
  const scene::Indices& indices = scene.indices[static_cast<std::size_t>(primitive.indices)];
  made.indices = device_.create(
      gpu::BufferDesc{"debug indices", indices.size() * sizeof(std::uint32_t), gpu::Use::indices},
      std::as_bytes(std::span(indices)));
  made.count = static_cast<std::uint32_t>(indices.size());
  return made;
}

DebugView::Drawn DebugView::draw(DebugKind kind, const scene::Scene& scene,
                                 const scene::Camera& camera, int width, int height) {
  const bool sums = kind == DebugKind::interior_layers || kind == DebugKind::path_length;
  gpu::PipelineRef& pipeline = sums ? sums_ : surfaces_;
  if (!pipeline)
    pipeline = device_.create(
        gpu::PipelineDesc{.label = sums ? "debug sums" : "debug surfaces",
                          .vertex = "debug_view.vert",
                          .fragment = "debug_view.frag",
                          .constants = {gpu::constant(0, sums)},
                          .bindings = {{.stride = 12}, {.stride = 12}},
                          .attributes = {{.location = 0, .components = 3, .binding = 0},
                                         {.location = 1, .components = 3, .binding = 1}},
                          .colors = {gpu::Format::rgba32f},
                          .depth = sums ? gpu::Format::none : gpu::Format::depth32f,
                          .cull = gpu::Cull::none,
                          .blend = sums ? gpu::Blend::add : gpu::Blend::none});
  const auto target = [&](gpu::TextureRef& texture, const char* label, gpu::Format format,
                          gpu::Use use) {
    if (!texture || texture->desc.width != width || texture->desc.height != height)
      texture = device_.create(gpu::TextureDesc{
          .label = label, .format = format, .width = width, .height = height, .use = use});
  };
  target(values_, "debug values", gpu::Format::rgba32f,
         gpu::Use::attachment | gpu::Use::sampled | gpu::Use::read_back);
  target(depth_, "debug depth", gpu::Format::depth32f, gpu::Use::attachment);

  const std::vector<Call> calls = calls_of(scene, sums);
  const std::vector<std::byte> blocks =
      blocks_of(calls, camera, static_cast<double>(width) / height);
  if (!blocks_ || blocks_->desc.bytes < blocks.size())
    blocks_ = device_.create(gpu::BufferDesc{"debug draws", blocks.size(), gpu::Use::uniforms});
  device_.upload(blocks_, 0, blocks);
  gpu::Pass pass{
      .label = "debug view",
      .colors = {{.view = gpu::whole(values_), .clear = std::array{0.0f, 0.0f, 0.0f, 0.0f}}}};
  if (!sums) pass.depth = gpu::DepthTarget{.view = gpu::whole(depth_), .clear = 0.0f};
  pass.record = [&](gpu::Encoder& encoder) {
    for (std::size_t i = 0; i < calls.size(); ++i) {
      const Mesh& drawn = mesh(scene, *calls[i].primitive);
      encoder.use(pipeline);
      encoder.buffer("DebugDraw", blocks_, i * gpu::block_alignment, sizeof(DrawBlock));
      encoder.cull(sums || calls[i].material->double_sided ? gpu::Cull::none : gpu::Cull::back);
      encoder.front_is_clockwise(calls[i].instance->mirrored);
      encoder.vertices(0, drawn.positions);
      encoder.vertices(1, drawn.normals);
      encoder.indices(drawn.indices);
      encoder.draw_indexed(drawn.count);
    }
  };
  // Meshes are uploaded before the pass that draws them.
  for (const Call& call : calls)
    mesh(scene, *call.primitive);
  device_.run(std::span(&pass, 1));
  const std::vector<std::byte> bytes = device_.read(values_, 0, 0);
  std::vector<float> values(bytes.size() / sizeof(float));
  std::memcpy(values.data(), bytes.data(), bytes.size());
  return coloured(kind, values, width, height);
}

} // namespace gg::viewer
