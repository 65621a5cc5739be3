#include "frame/renderer.h"

#include "environment/stack.h"
#include "uniforms/camera.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

namespace gg::frame {
namespace {

constexpr gpu::Format color_format = gpu::Format::rgba32f;
constexpr gpu::Format depth_format = gpu::Format::depth32f;

// Constants of the stages that belong to a pass, not to a material.
constexpr std::uint32_t looks_around = 41, most_bounces = 42;

// Of a depth in floats: four products and sums make a clip coordinate, and a division the depth.
constexpr double depth_rounding = 8.0 * std::numeric_limits<float>::epsilon();

needs::View view_of(const FrameDesc& desc) {
  needs::View view{.camera = desc.camera,
                   .width = desc.width,
                   .height = desc.height,
                   .samples = desc.samples,
                   .method = desc.method,
                   .correlated_smith = desc.correlated_smith,
                   .multiple_scattering = desc.multiple_scattering};
  if (const environment::Stack* stack = desc.environment.stack)
    view.environment =
        bytes(stack->even->desc) + bytes(stack->odd->desc) + bytes(stack->irradiance->desc);
  return view;
}

// Samples lie up to half a pixel off.
uniforms::RegionData region_of(const needs::Region& region, const FrameDesc& desc, double depth) {
  const glm::dvec2 pixel(2.0 / desc.width, 2.0 / desc.height);
  return {glm::vec4(region.box.low - pixel, region.box.high + pixel), glm::vec4(glm::dvec4(depth))};
}

tables::DeviceTables upload_tables(gpu::Device& device, const needs::Needs& needs) {
  tables::DeviceTables tables = tables::make_tables(device);
  for (const needs::Table& table : needs.tables) {
    if (table.kind == needs::TableKind::reflection_lobes)
      tables::upload_reflection(device, tables, table.model, table.taps);
    if (table.kind == needs::TableKind::interface_lobes)
      tables::upload_interfaces(device, tables, std::array{table.model}, table.taps);
    if (table.kind == needs::TableKind::wall_lobes)
      tables::upload_thin_walls(device, tables, table.model, table.taps);
  }
  return tables;
}

} // namespace

Renderer::Renderer(gpu::Device& device, const scene::Scene& scene, const FrameDesc& desc)
    : device_(device), desc_(desc), needs_(needs::needs_of(scene, view_of(desc))),
      uploaded_(device, needs_), tables_(upload_tables(device, needs_)),
      draws_(device, uploaded_, tables_),
      nearest_(device.create(
          gpu::SamplerDesc{.magnify = gpu::Filter::nearest, .minify = gpu::Filter::nearest})) {
  make_targets();
  make_frame_blocks();
  make_records();
  make_passes();
}

Renderer::~Renderer() = default;

void Renderer::make_targets() {
  const auto target = [&](const char* label, gpu::Format format, gpu::Use use) {
    return device_.create(gpu::TextureDesc{.label = label,
                                           .format = format,
                                           .width = desc_.width,
                                           .height = desc_.height,
                                           .use = gpu::Use::attachment | use});
  };
  color_ = target("scene color", color_format, gpu::Use::sampled | gpu::Use::read_back);
  depth_ = target("scene depth", depth_format, gpu::Use::sampled);
  if (needs_.target("average")) average_ = target("average", color_format, gpu::Use::read_back);
  if (const needs::Target* pyramid = needs_.target("screen pyramid"))
    backdrop_.emplace(device_,
                      Backdrop::Desc{.width = desc_.width,
                                     .height = desc_.height,
                                     .levels = pyramid->levels,
                                     .depth = needs_.target("backdrop depth") != nullptr,
                                     .glass_depth = needs_.target("glass depth") != nullptr});
  if (const needs::Target* interior = needs_.target("interior"))
    interior_.emplace(device_, desc_.width, desc_.height, interior->layers / 2);
  if (needs_.target("geometry")) geometry_.emplace(device_, desc_.width, desc_.height);
}

void Renderer::make_frame_blocks() {
  const scene::Camera& camera = desc_.camera;
  const double aspect = static_cast<double>(desc_.width) / desc_.height;
  const glm::dmat4 clip_from_world = needs::clip_from_world(needs_.view);
  std::vector<uniforms::FrameData> frames;
  for (int i = 0; i < desc_.samples; ++i) {
    const glm::dvec2 at = uniforms::sample_position(i, desc_.samples);
    const glm::dmat4 clip =
        uniforms::offset_by_pixels(at.x, at.y, desc_.width, desc_.height) * clip_from_world;
    uniforms::FrameData f{};
    f.clipFromWorld = glm::mat4(clip);
    f.worldFromClip = glm::mat4(glm::inverse(clip));
    f.eye = glm::vec4(glm::vec3(camera.world[3]), camera.orthographic ? 0.0f : 1.0f);
    f.viewDirection = glm::vec4(-glm::normalize(glm::vec3(camera.world[2])), 0.0f);
    f.environment = {std::cos(desc_.environment.rotation), std::sin(desc_.environment.rotation),
                     desc_.environment.intensity, 0.0f};
    if (desc_.environment.stack) f.stack = desc_.environment.stack->shape;
    f.picture = {desc_.width, desc_.height,
                 0.5 * uniforms::clip_from_view(camera, aspect)[1][1] * desc_.height,
                 backdrop_ ? backdrop_->last_level() : 0};
    f.boundsLow = glm::vec4(needs_.bounds.low, 0.0f);
    f.boundsHigh = glm::vec4(needs_.bounds.high, 0.0f);
    // Of a square of 1 / samples of the pixel's area: a twelfth of that.
    f.part = glm::vec4(glm::vec3(uniforms::beam_part(i, desc_.samples)),
                       1.0f / (12.0f * static_cast<float>(desc_.samples)));
    f.counts = {static_cast<int>(needs_.scene->lights.size()),
                static_cast<int>(needs_.walls.size()), 0, 0};
    for (std::size_t w = 0; w < needs_.walls.size(); ++w) {
      const needs::Wall& wall = needs_.walls[w];
      f.walls[3 * w] = glm::vec4(wall.centre, 0.0f);
      f.walls[3 * w + 1] = glm::vec4(wall.gradient_u, 0.0f);
      f.walls[3 * w + 2] = glm::vec4(wall.gradient_v, 0.0f);
    }
    frames.push_back(f);
  }
  frames_ = upload_uniforms(device_, "frame", frames);
}

Renderer::Recorded Renderer::recorded(const DrawPass& pass, const needs::LayerDraw& draw) {
  const gpu::Cull cull = draw.faces == needs::Faces::front  ? gpu::Cull::back
                         : draw.faces == needs::Faces::back ? gpu::Cull::front
                         : draw.draw->both_sides            ? gpu::Cull::none
                                                            : gpu::Cull::back;
  return {draw.draw, draws_.pipeline(pass, *draw.draw), cull};
}

void Renderer::make_records() {
  const DrawPass opaque{.label = "opaque", .fragment = "opaque.frag", .colors = {color_format}};
  // Once more over the opaque picture, which shows what there is to reflect.
  const DrawPass reflective{.label = "reflective",
                            .fragment = "opaque.frag",
                            .colors = {color_format},
                            .depth_write = false,
                            .constants = {gpu::constant(looks_around, true)}};
  const DrawPass blended{.label = "blended",
                         .fragment = "opaque.frag",
                         .colors = {color_format},
                         .depth_write = false,
                         .blend = gpu::Blend::over};
  const DrawPass refractive{.label = "refractive",
                            .fragment = "refractive.frag",
                            .colors = {color_format},
                            .blend = gpu::Blend::over,
                            .constants = {gpu::constant(looks_around, needs_.company),
                                          gpu::constant(most_bounces, needs::most_bounces)}};
  // By pixels: the solid's front faces into the depth first, then its region at its far end, which passes where something is
  // nearer: the depth test spares the shading beside it.
  const DrawPass hides{.label = "hides",
                       .fragment = "foreground.frag",
                       .colors = {color_format},
                       .blend = gpu::Blend::over};
  DrawPass by_region = refractive;
  by_region.label = "refractive region";
  by_region.by_region = true;
  by_region.fragment = "refractive_region.frag";
  by_region.depth_write = false;
  by_region.depth_compare = gpu::Compare::less_equal;
  std::vector<uniforms::RegionData> regions;
  make_opaque_regions(regions);
  for (const needs::Draw* draw : needs_.opaque)
    opaque_.push_back(recorded(opaque, {draw, needs::Faces::as_material}));
  for (const needs::Draw* draw : needs_.reflective)
    reflective_.push_back(recorded(reflective, {draw, needs::Faces::as_material}));
  for (const needs::LayerDraw& draw : needs_.over_opaque)
    over_opaque_.push_back(recorded(blended, draw));
  for (const needs::Layer& layer : needs_.layers) {
    RecordedRegions& recorded_regions = layer_regions_.emplace_back();
    for (const needs::Region& region : layer.regions) {
      const needs::Draw& draw = *region.draws.front();
      RecordedRegion& own = recorded_regions.emplace_back(
          RecordedRegion{{}, &draw, draws_.pipeline(by_region, draw), regions.size()});
      for (const needs::Draw* part : region.draws)
        own.first.push_back(recorded(hides, {part, needs::Faces::front}));
      regions.push_back(
          region_of(region, desc_, region.box.farthest_depth * (1.0 - depth_rounding)));
    }
    Records& records = layers_.emplace_back();
    for (const needs::LayerDraw& draw : layer.refractive)
      records.push_back(recorded(refractive, draw));
    for (const needs::LayerDraw& draw : layer.blended)
      records.push_back(recorded(blended, draw));
  }
  if (!regions.empty()) regions_ = upload_uniforms(device_, "regions", regions);
  if (needs_.sky)
    sky_ = device_.create(gpu::PipelineDesc{.label = "sky",
                                            .vertex = "fullscreen.vert",
                                            .fragment = "sky.frag",
                                            .colors = {color_format},
                                            .depth = depth_format,
                                            .depth_write = false});
  if (average_)
    accumulate_ = device_.create(
        gpu::PipelineDesc{.label = "accumulate",
                          .vertex = "fullscreen.vert",
                          .fragment = "accumulate.frag",
                          .constants = {gpu::constant(0, 1.0f / static_cast<float>(desc_.samples))},
                          .colors = {color_format},
                          .blend = gpu::Blend::add});
}

void Renderer::make_opaque_regions(std::vector<uniforms::RegionData>& regions) {
  const DrawPass geometry{
      .label = "geometry", .fragment = "geometry.frag", .colors = {GeometryBuffer::texel_format}};
  const DrawPass deferred{.label = "deferred",
                          .by_region = true,
                          .fragment = "opaque_region.frag",
                          .colors = {color_format},
                          .depth_write = false,
                          .depth_compare = gpu::Compare::equal};
  DrawPass reflective = deferred;
  reflective.label = "deferred reflective";
  reflective.constants = {gpu::constant(looks_around, true)};
  for (const needs::Region& region : needs_.opaque_regions) {
    const needs::Draw& draw = *region.draws.front();
    RecordedRegion& own = opaque_regions_.emplace_back(
        RecordedRegion{{}, &draw, draws_.pipeline(deferred, draw), regions.size()});
    for (const needs::Draw* part : region.draws)
      own.first.push_back(recorded(geometry, {part, needs::Faces::as_material}));
    if (std::ranges::find(needs_.reflective_regions, &region) != needs_.reflective_regions.end())
      reflective_regions_.push_back({{}, &draw, draws_.pipeline(reflective, draw), regions.size()});
    regions.push_back(region_of(region, desc_, GeometryBuffer::region_depth(regions.size())));
  }
  if (needs_.opaque_regions.empty()) return;
  needs::Region all = needs_.opaque_regions.front();
  for (const needs::Region& region : needs_.opaque_regions)
    grow(all.box, region.box);
  all_opaque_regions_ = regions.size();
  regions.push_back(region_of(all, desc_, 0.0));
}

void Renderer::draw_sample(int i, std::map<std::string, double>* times) {
  if (!times) {
    device_.run(passes_[static_cast<std::size_t>(i)]);
    return;
  }
  std::vector<gpu::PassTime> measured;
  device_.run(passes_[static_cast<std::size_t>(i)], &measured);
  for (const gpu::PassTime& pass : measured)
    (*times)[pass.label] += pass.ms;
}

void Renderer::draw(std::map<std::string, double>* times) {
  for (int i = 0; i < desc_.samples; ++i)
    draw_sample(i, times);
}

image::Image Renderer::read() {
  const std::vector<std::byte> bytes = device_.read(desc_.samples > 1 ? average_ : color_, 0, 0);
  image::Image picture(desc_.width, desc_.height, 4);
  std::memcpy(picture.values.data(), bytes.data(), bytes.size());
  return picture;
}

std::vector<std::string> Renderer::pass_labels() const {
  std::vector<std::string> labels;
  for (const gpu::Pass& pass : passes_.front())
    labels.push_back(pass.label);
  return labels;
}

} // namespace gg::frame
