#include "frame/execution.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace gg::frame {
namespace {

gpu::TextureDesc desc_of(const Target& target) {
  gpu::Use use = gpu::Use::attachment | gpu::Use::sampled;
  if (target.is_result || target.array) use = use | gpu::Use::read_back;
  return {.label = target.name,
          .shape = target.array ? gpu::Shape::d2_array : gpu::Shape::d2,
          .format = target.format,
          .width = target.width,
          .height = target.height,
          .layers = target.layers,
          .levels = target.levels,
          .use = use};
}

bool fits(const gpu::TextureDesc& a, const gpu::TextureDesc& b) {
  return a.shape == b.shape && a.format == b.format && a.width == b.width && a.height == b.height
         && a.layers == b.layers && a.levels == b.levels && a.use == b.use;
}

} // namespace

Execution::Execution(gpu::Device& device)
    : device_(device), nearest_(device.create(gpu::SamplerDesc{.magnify = gpu::Filter::nearest,
                                                               .minify = gpu::Filter::nearest})),
      linear_(device.create(gpu::SamplerDesc{.between_levels = gpu::Filter::linear})) {}

// Those of this size that no target has; all of them, before the graph's own are chosen.
std::vector<gpu::TextureRef>& Execution::spare_of(int width, int height) {
  if (!spare_.empty()) std::ranges::move(textures_, std::back_inserter(spare_.front().textures));
  textures_.clear();
  auto found = std::ranges::find_if(
      spare_, [&](const OfSize& of) { return of.width == width && of.height == height; });
  if (found == spare_.end()) found = spare_.insert(found, {.width = width, .height = height});
  std::rotate(spare_.begin(), found, found + 1);
  double all = 0.0, largest = 0.0;
  for (const OfSize& of : spare_) {
    const double pixels = static_cast<double>(of.width) * of.height;
    all += pixels;
    largest = std::max(largest, pixels);
  }
  for (; all > 2.0 * largest; spare_.pop_back())
    all -= static_cast<double>(spare_.back().width) * spare_.back().height;
  return spare_.front().textures;
}

void Execution::set(const Graph& graph, Context& context, Shared shared) {
  graph_ = &graph;
  shared_ = std::move(shared);
  const Allocation allocation = allocate(graph);
  std::vector<gpu::TextureRef>& spare = spare_of(graph.width, graph.height);
  for (const std::size_t target : allocation.first) {
    const gpu::TextureDesc desc = desc_of(graph.targets[target]);
    // Of the same name first: what is attached to what stays as it was.
    auto found = std::ranges::find_if(spare, [&](const gpu::TextureRef& texture) {
      return texture->desc.label == desc.label && fits(texture->desc, desc);
    });
    if (found == spare.end())
      found = std::ranges::find_if(
          spare, [&](const gpu::TextureRef& texture) { return fits(texture->desc, desc); });
    if (found == spare.end()) {
      textures_.push_back(device_.create(desc));
      continue;
    }
    textures_.push_back(*found);
    spare.erase(found);
  }
  texture_of_ = allocation.texture_of;
  context.draws.expect([&] {
    for (const Pass& pass : graph.passes)
      pass.prepare(context);
  });
  records_.clear();
  for (const Pass& pass : graph.passes)
    records_.push_back(pass.prepare(context));
}

const gpu::TextureRef& Execution::texture(const std::string& target) const {
  return textures_[texture_of_[static_cast<std::size_t>(graph_->find(target)
                                                        - graph_->targets.data())]];
}

gpu::View Execution::view(const Part& part) const {
  gpu::View view = gpu::whole(textures_[texture_of_[part.target]]);
  if (part.level != Part::all) {
    view.level = part.level;
    view.level_count = 1;
  }
  if (part.layer != Part::all) {
    view.layer = part.layer;
    view.layer_count = 1;
  }
  return view;
}

gpu::View Execution::one(const Part& part) const {
  return view({part.target, std::max(part.level, 0), std::max(part.layer, 0)});
}

gpu::Pass Execution::pass(std::size_t i, int sample) const {
  const Pass& of = graph_->passes[i];
  gpu::Pass pass{.label = of.label};
  struct Bound {
    const char* name;
    gpu::View view;
    gpu::SamplerRef sampler;
  };
  std::vector<Bound> inputs;
  for (const Input& input : of.reads) {
    inputs.push_back(
        {input.name, view(input.part), input.filter == gpu::Filter::linear ? linear_ : nearest_});
    pass.reads.push_back(inputs.back().view);
  }
  if (of.shades) pass.reads.insert(pass.reads.end(), shared_.reads.begin(), shared_.reads.end());
  for (const ColorOutput& color : of.colors) {
    gpu::ColorTarget target{.view = one(color.part)};
    if (!color.accumulates || sample == 0) target.clear = color.clear;
    pass.colors.push_back(target);
  }
  if (of.depth)
    pass.depth = gpu::DepthTarget{.view = one({of.depth->target, Part::all, of.depth->layer}),
                                  .clear = of.depth->clear};
  pass.record = [this, sample, inputs, &record = records_[i]](gpu::Encoder& encoder) {
    shared_.bind(encoder, sample);
    for (const Bound& input : inputs)
      encoder.texture(input.name, input.view, input.sampler);
    record(encoder);
  };
  return pass;
}

std::vector<gpu::Pass> Execution::passes(int sample) const {
  std::vector<gpu::Pass> passes;
  for (std::size_t i = 0; i < graph_->passes.size(); ++i)
    if (sample == 0 || !graph_->passes[i].once) passes.push_back(pass(i, sample));
  return passes;
}

} // namespace gg::frame
