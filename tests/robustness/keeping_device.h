// A device that makes each pipeline once, for whoever asks: scenes that differ in a byte mostly have the same, and drivers that
// compile on the processor take seconds for one.
#pragma once

#include "gpu/device.h"
#include "gpu/pipeline_key.h"

#include <map>
#include <string>
#include <vector>

namespace gg::test {

class KeepingDevice : public gpu::Device {
public:
  explicit KeepingDevice(gpu::Device& device) : device_(device) {}

  gpu::PipelineRef create(const gpu::PipelineDesc& desc) override {
    return kept(gpu::key_of(desc), [&] { return device_.create(desc); });
  }
  gpu::PipelineRef create(const gpu::ComputeDesc& desc) override {
    return kept(gpu::key_of(desc), [&] { return device_.create(desc); });
  }
  void expect(std::span<const gpu::PipelineDesc> pipelines) override { expect_new(pipelines); }
  void expect(std::span<const gpu::ComputeDesc> pipelines) override { expect_new(pipelines); }

  const gpu::DeviceInfo& info() const override { return device_.info(); }
  gpu::BufferRef create(const gpu::BufferDesc& desc, std::span<const std::byte> contents) override {
    return device_.create(desc, contents);
  }
  gpu::TextureRef create(const gpu::TextureDesc& desc) override { return device_.create(desc); }
  gpu::SamplerRef create(const gpu::SamplerDesc& desc) override { return device_.create(desc); }
  void upload(const gpu::TextureRef& texture, int level, int layer,
              std::span<const std::byte> texels) override {
    device_.upload(texture, level, layer, texels);
  }
  void upload(const gpu::BufferRef& buffer, std::size_t offset,
              std::span<const std::byte> bytes) override {
    device_.upload(buffer, offset, bytes);
  }
  void generate_mipmaps(const gpu::TextureRef& texture) override {
    device_.generate_mipmaps(texture);
  }
  std::vector<std::byte> read(const gpu::TextureRef& texture, int level, int layer) override {
    return device_.read(texture, level, layer);
  }
  std::vector<std::byte> read(const gpu::BufferRef& buffer, std::size_t offset,
                              std::size_t bytes) override {
    return device_.read(buffer, offset, bytes);
  }
  void run(std::span<const gpu::Pass> passes, std::vector<gpu::PassTime>* times) override {
    device_.run(passes, times);
  }
  void finish() override { device_.finish(); }
  std::size_t memory_bytes() const override { return device_.memory_bytes(); }
  int max_texture_size() const override { return device_.max_texture_size(); }
  gpu::DeviceCounters counters() const override { return device_.counters(); }

private:
  // Some megabytes each; those of a few dozen kinds of scenes.
  static constexpr std::size_t most = 1000;

  template <class Make>
  gpu::PipelineRef kept(const std::string& key, const Make& make) {
    if (pipelines_.size() >= most) pipelines_.clear();
    gpu::PipelineRef& pipeline = pipelines_[key];
    if (!pipeline) pipeline = make();
    return pipeline;
  }

  template <class Desc>
  void expect_new(std::span<const Desc> pipelines) {
    std::vector<Desc> unknown;
    for (const Desc& desc : pipelines)
      if (!pipelines_.contains(gpu::key_of(desc))) unknown.push_back(desc);
    device_.expect(unknown);
  }

  gpu::Device& device_;
  std::map<std::string, gpu::PipelineRef> pipelines_;
};

} // namespace gg::test
