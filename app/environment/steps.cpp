#include "environment/steps.h"

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <utility>

namespace gg::environment {

Steps::Steps(gpu::Device& device)
    : device_(device), point_(device.create(gpu::SamplerDesc{.magnify = gpu::Filter::nearest,
                                                             .minify = gpu::Filter::nearest})) {}

void Steps::add(const std::string& label, const gpu::PipelineRef& pipeline,
                const EnvironmentStep& step, std::vector<Bound> textures, std::vector<Bound> images,
                int groups_per_edge) {
  gpu::Pass pass;
  pass.label = label;
  for (const Bound& b : textures)
    pass.reads.push_back(b.view);
  for (const Bound& b : images)
    pass.storage.push_back(b.view);
  const std::size_t offset = values_.size() * gpu::block_alignment;
  values_.push_back(step);
  const auto edge = static_cast<std::uint32_t>(groups_per_edge);
  pass.record = [=, this, textures = std::move(textures),
                 images = std::move(images)](gpu::Encoder& encoder) {
    encoder.use(pipeline);
    encoder.buffer("Step", blocks_, offset, sizeof(EnvironmentStep));
    for (const Bound& b : textures)
      encoder.texture(b.name, b.view, point_);
    for (const Bound& b : images)
      encoder.image(b.name, b.view);
    encoder.dispatch(edge, edge, 6);
  };
  passes_.push_back(std::move(pass));
}

void Steps::upload_blocks() {
  std::vector<std::byte> bytes(values_.size() * gpu::block_alignment);
  for (std::size_t i = 0; i < values_.size(); ++i)
    std::memcpy(&bytes[i * gpu::block_alignment], &values_[i], sizeof(EnvironmentStep));
  blocks_ =
      device_.create(gpu::BufferDesc{"environment steps", bytes.size(), gpu::Use::uniforms}, bytes);
}

void Steps::clear() {
  passes_.clear();
  values_.clear();
  blocks_.reset();
  ran_ = 0;
}

void Steps::run(std::vector<gpu::PassTime>* times) {
  if (!blocks_) upload_blocks();
  device_.run(std::span(passes_).subspan(ran_), times);
  clear();
}

std::size_t Steps::run_one() {
  if (passes_.empty()) return 0;
  if (!blocks_) upload_blocks();
  device_.run(std::span(passes_).subspan(ran_, 1));
  const std::size_t left = passes_.size() - ++ran_;
  if (left == 0) clear();
  return left;
}

} // namespace gg::environment
