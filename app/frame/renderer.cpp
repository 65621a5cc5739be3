#include "frame/renderer.h"

#include "environment/stack.h"
#include "frame/regions.h"
#include "frame/shadow_blocks.h"

#include <array>
#include <cstring>
#include <utility>

namespace gg::frame {

Renderer::Renderer(gpu::Device& device, const scene::Scene& scene, const FrameDesc& desc,
                   Prepared prepared)
    : device_(device), scene_(scene),
      shapes_(prepared.shapes ? std::move(*prepared.shapes) : needs::Shapes(scene)),
      uploaded_(device), tables_(tables::make_tables(device)),
      draws_(device, uploaded_, tables_), context_{device, needs_, draws_, regions_,
                                                   shadow_frames_},
      execution_(device) {
  uploaded_.use_coarse(prepared.coarse);
  set(desc);
}

Renderer::~Renderer() = default;

void Renderer::set(const FrameDesc& desc) {
  desc_ = desc;
  passes_.clear();
  needs_ = needs::needs_of(scene_, view_of(desc), &shapes_);
  graph_ = graph_of(needs_);
  uploaded_.set(needs_);
  upload_tables();
  const Target* pyramid = graph_.find("screen pyramid");
  update_uniforms(device_, frames_, "frame",
                  frame_blocks(desc, needs_, pyramid ? pyramid->levels : 1));
  update_uniforms(device_, regions_, "regions", region_blocks(needs_));
  if (!needs_.shadows.views.empty()) {
    update_uniforms(device_, shadow_frames_, "shadow frames", shadow_frames(needs_.shadows));
    update_uniforms(device_, shadows_, "shadows", std::vector{shadows_block(needs_.shadows)});
  }
  Execution::Shared shared{
      .bind = [this](gpu::Encoder& encoder, int sample) { bind(encoder, sample); },
      .reads = draws_.sampled()};
  if (const environment::Stack* stack = desc_.environment.stack)
    for (const gpu::TextureRef& cube : {stack->even, stack->odd, stack->irradiance})
      shared.reads.push_back(gpu::whole(cube));
  execution_.set(graph_, context_, std::move(shared));
  for (int i = 0; i < desc_.samples; ++i)
    passes_.push_back(execution_.passes(i));
}

void Renderer::upload_tables() {
  for (const needs::Table& table : needs_.tables) {
    std::string& file = table_files_[{&tables_.of(table.model), table.kind}];
    if (file == table.file) continue;
    file = table.file;
    if (table.kind == needs::TableKind::reflection_lobes)
      tables::upload_reflection(device_, tables_, table.model, table.lobes);
    if (table.kind == needs::TableKind::interface_lobes)
      tables::upload_interfaces(device_, tables_, std::array{table.model}, table.lobes);
    if (table.kind == needs::TableKind::wall_lobes)
      tables::upload_thin_walls(device_, tables_, table.model, table.lobes);
  }
}

void Renderer::bind(gpu::Encoder& encoder, int sample) const {
  encoder.buffer("Frame", frames_.buffer, frames_.offset(static_cast<std::size_t>(sample)),
                 frames_.size);
  encoder.buffer("Lights", uploaded_.lights());
  if (!needs_.shadows.views.empty()) encoder.buffer("Shadows", shadows_.buffer, 0, shadows_.size);
  const environment::Stack* stack = desc_.environment.stack;
  if (!stack) return;
  encoder.texture("stackEven", gpu::whole(stack->even), stack->sampler);
  encoder.texture("stackOdd", gpu::whole(stack->odd), stack->sampler);
  encoder.texture("irradianceCube", gpu::whole(stack->irradiance), stack->sampler);
}

std::vector<gpu::PipelineDesc> Renderer::missing(const FrameDesc& desc) {
  const needs::Needs needs = needs::needs_of(scene_, view_of(desc), &shapes_);
  const Graph graph = graph_of(needs);
  Context context{device_, needs, draws_, regions_, shadow_frames_};
  return draws_.missing([&] {
    for (const Pass& pass : graph.passes)
      pass.prepare(context);
  });
}

void Renderer::draw_sample(int i, std::map<std::string, double>* times) {
  run(passes_[static_cast<std::size_t>(i)], times);
}

void Renderer::draw_pass(int sample, std::size_t pass, std::map<std::string, double>* times) {
  run(std::span(passes_[static_cast<std::size_t>(sample)]).subspan(pass, 1), times);
}

void Renderer::run(std::span<const gpu::Pass> passes, std::map<std::string, double>* times) {
  if (!times) {
    device_.run(passes);
    return;
  }
  std::vector<gpu::PassTime> measured;
  device_.run(passes, &measured);
  for (const gpu::PassTime& pass : measured)
    (*times)[pass.label] += pass.ms;
}

void Renderer::draw(std::map<std::string, double>* times) {
  for (int i = 0; i < desc_.samples; ++i)
    draw_sample(i, times);
}

const gpu::TextureRef& Renderer::picture() const {
  return execution_.texture(desc_.samples > 1 ? "average" : "scene color");
}

image::Image Renderer::read() {
  const std::vector<std::byte> bytes = device_.read(picture(), 0, 0);
  image::Image picture(desc_.width, desc_.height, 4);
  std::memcpy(picture.values.data(), bytes.data(), bytes.size());
  return picture;
}

std::vector<std::string> Renderer::pass_labels() const {
  std::vector<std::string> labels;
  for (const Pass& pass : graph_.passes)
    labels.push_back(pass.label);
  return labels;
}

} // namespace gg::frame
