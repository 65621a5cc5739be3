#include "gpu/opengl/device.h"

#include "core/clock.h"
#include "core/error.h"

#include <algorithm>

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
    : CheckedDevice(Backend::opengl, context->limits()), context_(std::move(context)),
      info_(std::move(info)), encoder_(context_, names_), timers_(context_) {}

BufferRef GlDevice::make(const BufferDesc& desc, std::span<const std::byte> contents) {
  return std::make_shared<GlBuffer>(context_, desc, contents);
}

TextureRef GlDevice::make(const TextureDesc& desc) {
  return std::make_shared<GlTexture>(context_, desc);
}

SamplerRef GlDevice::make(const SamplerDesc& desc) {
  return std::make_shared<GlSampler>(context_, desc);
}

PipelineRef GlDevice::make(const PipelineDesc& desc) {
  return std::make_shared<GlPipeline>(context_, names_, desc);
}

PipelineRef GlDevice::make(const ComputeDesc& desc) {
  return std::make_shared<GlPipeline>(context_, names_, desc);
}

void GlDevice::fill(const TextureRef& texture, int level, int layer,
                    std::span<const std::byte> texels) {
  GlTexture& to = of(texture, "an upload");
  to.upload(level, layer, texels);
}

void GlDevice::fill(const BufferRef& buffer, std::size_t offset, std::span<const std::byte> bytes) {
  const GlBuffer& to = of(buffer, "an upload");
  const GladGLContext& gl = context_->gl();
  context_->make_visible(to.written);
  gl.NamedBufferSubData(to.name, static_cast<GLintptr>(offset),
                        static_cast<GLsizeiptr>(bytes.size()), bytes.data());
  context_->check("filling " + describe(to.desc));
}

void GlDevice::fill_levels(const TextureRef& texture) {
  const GlTexture& of_texture = of(texture, "making mip levels");
  const GladGLContext& gl = context_->gl();
  context_->make_visible(of_texture.written);
  gl.GenerateTextureMipmap(of_texture.name);
  context_->check("making mip levels of " + describe(of_texture.desc));
}

std::vector<std::byte> GlDevice::fetch(const TextureRef& texture, int level, int layer) {
  GlTexture& from = of(texture, "reading back");
  return from.read(level, layer);
}

std::vector<std::byte> GlDevice::fetch(const BufferRef& buffer, std::size_t offset,
                                       std::size_t bytes) {
  const GlBuffer& from = of(buffer, "reading back");
  std::vector<std::byte> result(bytes);
  const GladGLContext& gl = context_->gl();
  context_->make_visible(from.written);
  gl.GetNamedBufferSubData(from.name, static_cast<GLintptr>(offset), static_cast<GLsizeiptr>(bytes),
                           result.data());
  context_->check("reading " + describe(from.desc));
  return result;
}

void GlDevice::run(const Pass& pass) {
  gpu::check(pass, limits());
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
  context_->counters.record_ms += ms_since(start);
  if (times) timers_.collect(passes, *times);
}

void GlDevice::finish() {
  context_->gl().Finish();
  context_->check("finishing");
}

} // namespace gg::gpu::opengl
