#include "gpu/opengl/device.h"

#include "core/error.h"
#include "gpu/shaders/compile.h"

#include <algorithm>
#include <chrono>

namespace gg::gpu::opengl {
namespace {

// A debug group for as long as it lives.
class Group {
public:
  Group(const GladGLContext& gl, const std::string& label) : gl_(gl) {
    gl.PushDebugGroup(GL_DEBUG_SOURCE_APPLICATION, 0, static_cast<GLsizei>(label.size()),
                      label.data());
  }
  ~Group() { gl_.PopDebugGroup(); }
  Group(const Group&) = delete;
  Group& operator=(const Group&) = delete;

private:
  const GladGLContext& gl_;
};

} // namespace

GlDevice::GlDevice(ContextRef context, DeviceInfo info)
    : context_(std::move(context)), info_(std::move(info)), encoder_(context_, names_),
      timers_(context_) {}

BufferRef GlDevice::create(const BufferDesc& desc, std::span<const std::byte> contents) {
  gpu::check(desc, contents, context_->limits());
  return std::make_shared<GlBuffer>(context_, desc, contents);
}

TextureRef GlDevice::create(const TextureDesc& desc) {
  gpu::check(desc, context_->limits());
  return std::make_shared<GlTexture>(context_, desc);
}

SamplerRef GlDevice::create(const SamplerDesc& desc) {
  const auto known =
      std::ranges::find_if(samplers_, [&](const SamplerRef& s) { return s->desc == desc; });
  if (known != samplers_.end()) return *known;
  return samplers_.emplace_back(std::make_shared<GlSampler>(context_, desc));
}

PipelineRef GlDevice::create(const PipelineDesc& desc) {
  gpu::check(desc, context_->limits());
  return std::make_shared<GlPipeline>(context_, names_, desc);
}

PipelineRef GlDevice::create(const ComputeDesc& desc) {
  return std::make_shared<GlPipeline>(context_, names_, desc);
}

void GlDevice::expect(std::span<const std::string> stages) {
  shaders::compile_ahead(stages, Backend::opengl);
}

void GlDevice::upload(const TextureRef& texture, int level, int layer,
                      std::span<const std::byte> texels) {
  GlTexture& to = of(texture, "an upload");
  check_texels(to.desc, level, layer, texels.size());
  to.upload(level, layer, texels);
}

void GlDevice::upload(const BufferRef& buffer, std::size_t offset,
                      std::span<const std::byte> bytes) {
  const GlBuffer& to = of(buffer, "an upload");
  check_range(to.desc, offset, bytes.size());
  if (bytes.empty()) return;
  const GladGLContext& gl = context_->gl();
  context_->make_visible(to.written);
  gl.NamedBufferSubData(to.name, static_cast<GLintptr>(offset),
                        static_cast<GLsizeiptr>(bytes.size()), bytes.data());
  context_->check("filling " + describe(to.desc));
}

void GlDevice::generate_mipmaps(const TextureRef& texture) {
  const GlTexture& of_texture = of(texture, "making mip levels");
  const GladGLContext& gl = context_->gl();
  context_->make_visible(of_texture.written);
  gl.GenerateTextureMipmap(of_texture.name);
  context_->check("making mip levels of " + describe(of_texture.desc));
}

std::vector<std::byte> GlDevice::read(const TextureRef& texture, int level, int layer) {
  GlTexture& from = of(texture, "reading back");
  check_part(from.desc, level, layer);
  return from.read(level, layer);
}

std::vector<std::byte> GlDevice::read(const BufferRef& buffer, std::size_t offset,
                                      std::size_t bytes) {
  const GlBuffer& from = of(buffer, "reading back");
  check_range(from.desc, offset, bytes);
  std::vector<std::byte> result(bytes);
  if (bytes == 0) return result;
  const GladGLContext& gl = context_->gl();
  context_->make_visible(from.written);
  gl.GetNamedBufferSubData(from.name, static_cast<GLintptr>(offset), static_cast<GLsizeiptr>(bytes),
                           result.data());
  context_->check("reading " + describe(from.desc));
  return result;
}

void GlDevice::run(const Pass& pass) {
  gpu::check(pass, context_->limits());
  const Group group(context_->gl(), pass.label);
  struct End {
    GlEncoder& encoder;
    ~End() { encoder.end(); }
  } const end{encoder_};
  encoder_.begin(pass);
  pass.record(encoder_);
  ++context_->counters.passes;
}

void GlDevice::run(std::span<const Pass> passes, std::vector<PassTime>* times) {
  using Clock = std::chrono::steady_clock;
  const auto start = Clock::now();
  timers_.discard();
  for (const Pass& pass : passes) {
    if (times) timers_.stamp();
    run(pass);
    if (times) timers_.stamp();
    context_->check("pass '" + pass.label + "'");
  }
  context_->gl().Flush();
  ++context_->counters.submissions;
  context_->counters.record_ms +=
      std::chrono::duration<double, std::milli>(Clock::now() - start).count();
  if (times) timers_.collect(passes, *times);
}

void GlDevice::finish() {
  context_->gl().Finish();
  context_->check("finishing");
}

} // namespace gg::gpu::opengl
