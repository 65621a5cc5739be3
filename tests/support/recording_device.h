// A device that makes nothing and remembers which pipelines it was asked for: what a scene compiles, without a GPU.
#pragma once

#include "gpu/device.h"

#include <vector>

namespace gg::test {

class RecordingDevice : public gpu::Device {
public:
  std::vector<gpu::PipelineDesc> pipelines; // in the order in which they were asked for

  const gpu::DeviceInfo& info() const override { return info_; }
  gpu::BufferRef create(const gpu::BufferDesc& desc, std::span<const std::byte>) override {
    return made<gpu::Buffer>(desc);
  }
  gpu::TextureRef create(const gpu::TextureDesc& desc) override { return made<gpu::Texture>(desc); }
  gpu::SamplerRef create(const gpu::SamplerDesc& desc) override { return made<gpu::Sampler>(desc); }
  gpu::PipelineRef create(const gpu::PipelineDesc& desc) override {
    pipelines.push_back(desc);
    return std::make_shared<gpu::Pipeline>();
  }
  gpu::PipelineRef create(const gpu::ComputeDesc&) override {
    return std::make_shared<gpu::Pipeline>();
  }
  void expect(std::span<const gpu::PipelineDesc>) override {}
  void expect(std::span<const gpu::ComputeDesc>) override {}
  void upload(const gpu::TextureRef&, int, int, std::span<const std::byte>) override {}
  void upload(const gpu::BufferRef&, std::size_t, std::span<const std::byte>) override {}
  void generate_mipmaps(const gpu::TextureRef&) override {}
  std::vector<std::byte> read(const gpu::TextureRef& texture, int, int) override {
    return std::vector<std::byte>(gpu::bytes(texture->desc));
  }
  std::vector<std::byte> read(const gpu::BufferRef&, std::size_t, std::size_t bytes) override {
    return std::vector<std::byte>(bytes);
  }
  void run(std::span<const gpu::Pass>, std::vector<gpu::PassTime>*) override {}
  void finish() override {}
  std::size_t memory_bytes() const override { return 0; }
  int max_texture_size() const override { return 16384; }
  gpu::DeviceCounters counters() const override { return {}; }

private:
  template <class T, class Desc>
  static std::shared_ptr<T> made(const Desc& desc) {
    auto object = std::make_shared<T>();
    object->desc = desc;
    return object;
  }

  gpu::DeviceInfo info_;
};

} // namespace gg::test
