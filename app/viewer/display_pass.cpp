#include "viewer/display_pass.h"

#include "uniforms/camera.h"

#include <cstring>

namespace gg::viewer {
namespace {

using glm::vec4;
#include "../../shaders/interface/display.glsl"
static_assert(sizeof(DisplayData) == 64);

constexpr vec4 around{0.09f, 0.09f, 0.10f, 1.0f}; // the panels' own dark grey

template <class T>
std::span<const std::byte> bytes_of(const T& value) {
  return std::as_bytes(std::span(&value, 1));
}

// RGBA8, of this size; made again where it has another.
void make_target(gpu::Device& device, gpu::TextureRef& target, const char* label, int width,
                 int height) {
  if (target && target->desc.width == width && target->desc.height == height) return;
  target = device.create(
      gpu::TextureDesc{.label = label,
                       .format = gpu::Format::rgba8,
                       .width = width,
                       .height = height,
                       .use = gpu::Use::attachment | gpu::Use::sampled | gpu::Use::read_back});
}

} // namespace

DisplayPass::DisplayPass(gpu::Device& device)
    : device_(device), linear_(device.create(gpu::SamplerDesc{})),
      block_(device.create(gpu::BufferDesc{"display", sizeof(DisplayData), gpu::Use::uniforms})),
      small_block_(
          device.create(gpu::BufferDesc{"small display", sizeof(DisplayData), gpu::Use::uniforms})),
      picked_block_(
          device.create(gpu::BufferDesc{"picked", sizeof(glm::mat4), gpu::Use::uniforms})),
      outline_block_(
          device.create(gpu::BufferDesc{"outline", sizeof(glm::vec4), gpu::Use::uniforms})),
      nothing_(device.create(gpu::TextureDesc{.label = "nothing", .format = gpu::Format::rgba8})) {}

const gpu::PipelineRef& DisplayPass::pipeline(const Kind& kind) {
  gpu::PipelineRef& found = display_[kind];
  if (!found)
    found = device_.create(gpu::PipelineDesc{
        .label = "display",
        .vertex = "fullscreen.vert",
        .fragment = "display.frag",
        .constants = {gpu::constant(0, static_cast<int>(kind.tone_map)),
                      gpu::constant(1, kind.beside), gpu::constant(2, kind.outlined),
                      gpu::constant(3, kind.encoded)},
        .colors = {gpu::Format::rgba8}});
  return found;
}

void DisplayPass::draw_into(const gpu::TextureRef& target, const Show& show, const Kind& kind,
                            const gpu::BufferRef& block) {
  DisplayData data{};
  data.area = {static_cast<float>(show.picture_width), static_cast<float>(show.picture_height),
               0.0f, 0.0f};
  data.picture = {show.factor, 0.0f, 0.0f, 0.0f};
  data.other = {1.0f, 0.0f, 1.0f, 0.0f};
  if (show.beside)
    data.other = {show.beside->factor, show.beside->encoded ? 1.0f : 0.0f,
                  show.beside->side_by_side ? 0.5f : show.beside->from,
                  show.beside->side_by_side ? 1.0f : 0.0f};
  data.around = around;
  device_.upload(block, 0, bytes_of(data));
  const gpu::TextureRef other = show.beside ? show.beside->texture : nothing_;
  const gpu::TextureRef outline = kind.outlined ? outline_ : nothing_;
  const gpu::TextureRef picture = show.picture ? show.picture : nothing_;
  const gpu::PipelineRef& display = pipeline(kind);
  gpu::Pass pass{.label = "display",
                 .colors = {{.view = gpu::whole(target)}},
                 .reads = {gpu::whole(picture), gpu::whole(other), gpu::whole(outline)},
                 .record = [&](gpu::Encoder& encoder) {
                   encoder.use(display);
                   encoder.buffer("Display", block);
                   encoder.texture("pictureColor", gpu::whole(picture), linear_);
                   encoder.texture("otherColor", gpu::whole(other), linear_);
                   encoder.texture("pickedOutline", gpu::whole(outline), linear_);
                   encoder.draw(3);
                 }};
  device_.run(std::span(&pass, 1));
}

// What is much smaller than the screen shows it is encoded first: a software device takes 8 of 11 ms for that at full size.
bool DisplayPass::is_small(const Show& show) {
  return show.picture && !show.beside && 2 * show.picture->desc.width <= show.picture_width
         && 2 * show.picture->desc.height <= show.picture_height;
}

// The picture encoded for display at its own size.
gpu::TextureRef DisplayPass::encoded_small(const Show& show) {
  const gpu::TextureDesc& desc = show.picture->desc;
  if (show.being_drawn && small_) return small_;
  make_target(device_, small_, "small window", desc.width, desc.height);
  Show small = show;
  small.width = small.picture_width = desc.width;
  small.height = small.picture_height = desc.height;
  draw_into(small_, small, {.tone_map = show.tone_map}, small_block_);
  return small_;
}

const gpu::TextureRef& DisplayPass::draw(const Show& show) {
  make_target(device_, target_, "window", show.width, show.height);
  Kind kind{.tone_map = show.tone_map,
            .beside = show.beside.has_value(),
            .outlined = outline_ != nullptr};
  if (!is_small(show)) {
    draw_into(target_, show, kind, block_);
    return target_;
  }
  Show enlarged = show;
  enlarged.picture = encoded_small(show);
  enlarged.factor = 1.0f;
  draw_into(target_, enlarged, {.outlined = kind.outlined, .encoded = true}, block_);
  return target_;
}

void DisplayPass::pick(const scene::Scene& scene, scene::Index instance) {
  picked_.clear();
  outline_.reset();
  outlined_ = {};
  if (instance == scene::none) return;
  const scene::Instance& placed = scene.instances[static_cast<std::size_t>(instance)];
  world_ = placed.world;
  for (const scene::Primitive& primitive :
       scene.meshes[static_cast<std::size_t>(placed.mesh)].primitives) {
    const auto& positions = scene.streams[static_cast<std::size_t>(primitive.positions)].values;
    const auto& indices = scene.indices[static_cast<std::size_t>(primitive.indices)];
    if (indices.empty()) continue;
    Part part;
    part.positions = device_.create(
        gpu::BufferDesc{"picked positions", positions.size() * sizeof(float), gpu::Use::vertices},
        std::as_bytes(std::span(positions)));
    part.indices =
        device_.create(gpu::BufferDesc{"picked indices", indices.size() * sizeof(std::uint32_t),
                                       gpu::Use::indices},
                       std::as_bytes(std::span(indices)));
    part.count = static_cast<std::uint32_t>(indices.size());
    picked_.push_back(std::move(part));
  }
  if (!mask_pipeline_)
    mask_pipeline_ = device_.create(
        gpu::PipelineDesc{.label = "picked mask",
                          .vertex = "picked_mask.vert",
                          .fragment = "picked_mask.frag",
                          .bindings = {{.stride = 3 * sizeof(float)}},
                          .attributes = {{.location = 0, .components = 3, .binding = 0}},
                          .colors = {gpu::Format::r8},
                          .cull = gpu::Cull::none});
  if (!outline_pipeline_)
    outline_pipeline_ = device_.create(gpu::PipelineDesc{.label = "picked outline",
                                                         .vertex = "fullscreen.vert",
                                                         .fragment = "picked_outline.frag",
                                                         .colors = {gpu::Format::r8}});
}

void DisplayPass::see(const scene::Camera& camera, int width, int height, float outline,
                      bool moving) {
  if (picked_.empty()) return;
  const double aspect = static_cast<double>(width) / height;
  const glm::mat4 clip(uniforms::clip_from_view(camera, aspect) * uniforms::view_from_world(camera)
                       * glm::dmat4(world_));
  if (moving) {
    width = std::max(width / 2, 1), height = std::max(height / 2, 1);
    outline *= 0.5f;
  }
  Outlined& to = outlined_[moving];
  const bool fits = to.mask && to.mask->desc.width == width && to.mask->desc.height == height;
  if (!fits)
    for (gpu::TextureRef* texture : {&to.mask, &to.outline})
      *texture = device_.create(gpu::TextureDesc{.label = "picked",
                                                 .format = gpu::Format::r8,
                                                 .width = width,
                                                 .height = height,
                                                 .use = gpu::Use::attachment | gpu::Use::sampled});
  outline_ = to.outline;
  if (fits && to.clip_from_mesh == clip) return;
  to.clip_from_mesh = clip;
  device_.upload(picked_block_, 0, bytes_of(clip));
  device_.upload(
      outline_block_, 0,
      bytes_of(glm::vec4(static_cast<float>(width), static_cast<float>(height), outline, 0.0f)));
  const gpu::Pass passes[] = {
      {.label = "picked mask",
       .colors = {{.view = gpu::whole(to.mask), .clear = std::array{0.0f, 0.0f, 0.0f, 0.0f}}},
       .record =
           [this](gpu::Encoder& encoder) {
             encoder.use(mask_pipeline_);
             encoder.buffer("Picked", picked_block_);
             for (const Part& part : picked_) {
               encoder.vertices(0, part.positions);
               encoder.indices(part.indices);
               encoder.draw_indexed(part.count);
             }
           }},
      {.label = "picked outline",
       .colors = {{.view = gpu::whole(to.outline)}},
       .reads = {gpu::whole(to.mask)},
       .record = [&, this](gpu::Encoder& encoder) {
         encoder.use(outline_pipeline_);
         encoder.buffer("Outline", outline_block_);
         encoder.texture("pickedMask", gpu::whole(to.mask), linear_);
         encoder.draw(3);
       }}};
  device_.run(passes);
}

gpu::TextureRef upload(gpu::Device& device, const image::Image& image, const char* label) {
  std::vector<float> rgba(
      4 * static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height), 1.0f);
  for (std::size_t i = 0; i < rgba.size() / 4; ++i)
    for (std::size_t c = 0; c < 3; ++c)
      rgba[4 * i + c] =
          image
              .values[i * static_cast<std::size_t>(image.channels) + (image.channels >= 3 ? c : 0)];
  gpu::TextureRef texture = device.create(gpu::TextureDesc{.label = label,
                                                           .format = gpu::Format::rgba32f,
                                                           .width = image.width,
                                                           .height = image.height});
  device.upload(texture, 0, 0, std::as_bytes(std::span(rgba)));
  return texture;
}

} // namespace gg::viewer
