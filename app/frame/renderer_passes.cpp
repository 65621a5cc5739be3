// The passes of a frame: what each of them reads, writes and records.
#include "environment/stack.h"
#include "frame/renderer.h"

namespace gg::frame {

void Renderer::bind_environment(gpu::Encoder& encoder) const {
  const environment::Stack& stack = *desc_.environment.stack;
  encoder.texture("stackEven", gpu::whole(stack.even), stack.sampler);
  encoder.texture("stackOdd", gpu::whole(stack.odd), stack.sampler);
  encoder.texture("irradianceCube", gpu::whole(stack.irradiance), stack.sampler);
}

std::vector<gpu::View> Renderer::sampled() const {
  std::vector<gpu::View> views = draws_.sampled();
  if (const environment::Stack* stack = desc_.environment.stack)
    for (const gpu::TextureRef& cube : {stack->even, stack->odd, stack->irradiance})
      views.push_back(gpu::whole(cube));
  return views;
}

void Renderer::begin(gpu::Encoder& encoder, int sample) const {
  encoder.buffer("Frame", frames_.buffer, frames_.offset(static_cast<std::size_t>(sample)),
                 frames_.size);
  encoder.buffer("Lights", uploaded_.lights());
  if (desc_.environment.stack) bind_environment(encoder);
}

void Renderer::record(gpu::Encoder& encoder, const Records& records) const {
  for (const auto& [draw, pipeline, cull] : records)
    draws_.record(encoder, pipeline, *draw, cull);
}

void Renderer::bind_region(gpu::Encoder& encoder, std::size_t block) const {
  encoder.buffer("Region", regions_.buffer, regions_.offset(block), regions_.size);
}

void Renderer::shade(gpu::Encoder& encoder, const RecordedRegion& region) const {
  bind_region(encoder, region.block);
  draws_.record_region(encoder, region.pipeline, *region.draw);
}

gpu::Pass Renderer::geometry_pass(int sample) const {
  return {.label = "geometry",
          .colors = {geometry_->texels()},
          .depth = gpu::DepthTarget{.view = gpu::whole(depth_), .clear = 0.0f},
          .record = [this, sample](gpu::Encoder& encoder) {
            begin(encoder, sample);
            for (const RecordedRegion& region : opaque_regions_) {
              bind_region(encoder, region.block);
              record(encoder, region.first);
            }
          }};
}

gpu::Pass Renderer::opaque_pass(int sample) const {
  gpu::DepthTarget depth{.view = gpu::whole(depth_)};
  if (!geometry_) depth.clear = 0.0f;
  return {.label = "opaque",
          .colors = {{.view = gpu::whole(color_), .clear = std::array{0.0f, 0.0f, 0.0f, 0.0f}}},
          .depth = depth,
          .reads = sampled(),
          .record = [this, sample](gpu::Encoder& encoder) {
            begin(encoder, sample);
            record(encoder, opaque_);
            if (sky_) {
              encoder.use(sky_);
              encoder.draw(3);
            }
            if (!needs_.shades_opaque_late()) record(encoder, over_opaque_);
          }};
}

gpu::Pass Renderer::material_depth_pass() const {
  return geometry_->material_depth_pass(
      depth_, [this](gpu::Encoder& encoder) { bind_region(encoder, all_opaque_regions_); });
}

gpu::Pass Renderer::deferred_pass(int sample) const {
  gpu::Pass pass{.label = "deferred",
                 .colors = {{.view = gpu::whole(color_)}},
                 .depth = geometry_->material_depth(),
                 .reads = sampled(),
                 .record = [this, sample](gpu::Encoder& encoder) {
                   begin(encoder, sample);
                   geometry_->bind(encoder);
                   for (const RecordedRegion& region : opaque_regions_)
                     shade(encoder, region);
                 }};
  pass.reads.push_back(geometry_->sampled());
  return pass;
}

gpu::Pass Renderer::over_opaque_pass(int sample) const {
  return {.label = "blended",
          .colors = {{.view = gpu::whole(color_)}},
          .depth = gpu::DepthTarget{.view = gpu::whole(depth_)},
          .reads = sampled(),
          .record = [this, sample](gpu::Encoder& encoder) {
            begin(encoder, sample);
            record(encoder, over_opaque_);
          }};
}

gpu::Pass Renderer::reflective_pass(const needs::Pass& of, int sample) const {
  gpu::Pass pass{.label = "reflective",
                 .colors = {{.view = gpu::whole(color_)}},
                 .depth = gpu::DepthTarget{.view = gpu::whole(depth_)},
                 .reads = sampled(),
                 .record = [this, sample, glass = of.part == 1](gpu::Encoder& encoder) {
                   begin(encoder, sample);
                   backdrop_->bind(encoder);
                   for (const auto& [draw, pipeline, cull] : reflective_)
                     if (!glass || needs::shows_glass(*draw))
                       draws_.record(encoder, pipeline, *draw, cull);
                 }};
  for (const gpu::View& view : backdrop_->sampled())
    pass.reads.push_back(view);
  return pass;
}

gpu::Pass Renderer::deferred_reflective_pass(const needs::Pass& of, int sample) const {
  gpu::Pass pass{.label = "reflective",
                 .colors = {{.view = gpu::whole(color_)}},
                 .depth = geometry_->material_depth(),
                 .reads = sampled(),
                 .record = [this, sample, glass = of.part == 1](gpu::Encoder& encoder) {
                   begin(encoder, sample);
                   backdrop_->bind(encoder);
                   geometry_->bind(encoder);
                   for (const RecordedRegion& region : reflective_regions_)
                     if (!glass || needs::shows_glass(*region.draw)) shade(encoder, region);
                 }};
  pass.reads.push_back(geometry_->sampled());
  for (const gpu::View& view : backdrop_->sampled())
    pass.reads.push_back(view);
  return pass;
}

gpu::Pass Renderer::interior_pass(const needs::Pass& pass, int sample) {
  std::vector<const needs::Draw*> solids;
  for (const needs::Draw* solid : needs_.layers[pass.layer].solids)
    if (pass.part < 2 * value_of(solid->key, needs::Feature::interior_pairs))
      solids.push_back(solid);
  return interior_->pass(draws_, solids, pass.part,
                         [this, sample](gpu::Encoder& encoder) { begin(encoder, sample); });
}

gpu::Pass Renderer::layer_pass(const needs::Pass& of, int sample) const {
  const needs::Layer& layer = needs_.layers[of.layer];
  gpu::Pass pass{.label = of.label,
                 .colors = {{.view = gpu::whole(color_)}},
                 .depth = gpu::DepthTarget{.view = gpu::whole(depth_)},
                 .reads = sampled()};
  if (layer.shows_behind())
    for (const gpu::View& view : backdrop_->sampled())
      pass.reads.push_back(view);
  if (!layer.solids.empty()) pass.reads.push_back(interior_->sampled());
  pass.record = [this, sample, behind_glass = of.glass_depth, &layer, &records = layers_[of.layer],
                 &regions = layer_regions_[of.layer]](gpu::Encoder& encoder) {
    begin(encoder, sample);
    if (layer.shows_behind()) backdrop_->bind(encoder, behind_glass);
    if (!layer.solids.empty()) interior_->bind(encoder);
    for (const RecordedRegion& region : regions) {
      record(encoder, region.first);
      shade(encoder, region);
    }
    record(encoder, records);
  };
  return pass;
}

gpu::Pass Renderer::accumulate_pass(int sample) const {
  gpu::ColorTarget average{.view = gpu::whole(average_)};
  if (sample == 0) average.clear = std::array{0.0f, 0.0f, 0.0f, 0.0f};
  return {.label = "accumulate",
          .colors = {average},
          .reads = {gpu::whole(color_)},
          .record = [this](gpu::Encoder& encoder) {
            encoder.use(accumulate_);
            encoder.texture("sampleColor", gpu::whole(color_), nearest_);
            encoder.draw(3);
          }};
}

gpu::Pass Renderer::made(const needs::Pass& pass, int sample) {
  switch (pass.kind) {
  case needs::PassKind::geometry:
    return geometry_pass(sample);
  case needs::PassKind::opaque:
    return opaque_pass(sample);
  case needs::PassKind::material_depth:
    return material_depth_pass();
  case needs::PassKind::deferred:
    return deferred_pass(sample);
  case needs::PassKind::over_opaque:
    return over_opaque_pass(sample);
  case needs::PassKind::backdrop:
    return backdrop_->copy_pass(color_, depth_, pass);
  case needs::PassKind::foreground:
    return backdrop_->foreground_pass(
        depth_, draws_, needs_.layers[pass.layer].foreground,
        [this, sample](gpu::Encoder& encoder) { begin(encoder, sample); });
  case needs::PassKind::pyramid:
    return backdrop_->level_pass(pass.part);
  case needs::PassKind::reflective:
    return reflective_pass(pass, sample);
  case needs::PassKind::deferred_reflective:
    return deferred_reflective_pass(pass, sample);
  case needs::PassKind::interior:
    return interior_pass(pass, sample);
  case needs::PassKind::layer:
    return layer_pass(pass, sample);
  case needs::PassKind::accumulate:
    return accumulate_pass(sample);
  }
  return {};
}

void Renderer::make_passes() {
  for (int i = 0; i < desc_.samples; ++i) {
    std::vector<gpu::Pass>& passes = passes_.emplace_back();
    for (const needs::Pass& pass : needs_.passes)
      passes.push_back(made(pass, i));
  }
}

} // namespace gg::frame
