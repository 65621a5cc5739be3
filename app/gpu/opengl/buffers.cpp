#include "core/error.h"
#include "gpu/opengl/formats.h"
#include "gpu/opengl/resources.h"

#include <algorithm>

namespace gg::gpu::opengl {

GlBuffer::GlBuffer(ContextRef owner, const BufferDesc& what, std::span<const std::byte> contents)
    : context(std::move(owner)), serial(context->next_serial()) {
  desc = what;
  const GladGLContext& gl = context->gl();
  gl.CreateBuffers(1, &name);
  const bool whole = contents.size() == desc.bytes;
  gl.NamedBufferStorage(name, static_cast<GLsizeiptr>(desc.bytes),
                        whole ? contents.data() : nullptr, GL_DYNAMIC_STORAGE_BIT);
  if (!whole && !contents.empty())
    gl.NamedBufferSubData(name, 0, static_cast<GLsizeiptr>(contents.size()), contents.data());
  context->label(GL_BUFFER, name, desc.label);
  try {
    context->check("creating " + describe(desc));
  } catch (...) {
    gl.DeleteBuffers(1, &name);
    throw;
  }
  context->held_bytes += desc.bytes;
  ++context->counters.created;
}

GlBuffer::~GlBuffer() {
  context->held_bytes -= desc.bytes;
  try {
    context->gl().DeleteBuffers(1, &name);
  } catch (const Error&) {
    // Not reachable from this thread: the context takes it along when it ends.
  }
}

GlSampler::GlSampler(ContextRef owner, const SamplerDesc& what)
    : context(std::move(owner)), serial(context->next_serial()) {
  desc = what;
  const GladGLContext& gl = context->gl();
  gl.CreateSamplers(1, &name);
  const auto set = [&](GLenum parameter, GLenum value) {
    gl.SamplerParameteri(name, parameter, static_cast<GLint>(value));
  };
  set(GL_TEXTURE_MAG_FILTER, opengl::name(desc.magnify));
  set(GL_TEXTURE_MIN_FILTER, opengl::name(desc.minify, desc.between_levels));
  set(GL_TEXTURE_WRAP_S, opengl::name(desc.u));
  set(GL_TEXTURE_WRAP_T, opengl::name(desc.v));
  set(GL_TEXTURE_WRAP_R, opengl::name(desc.w));
  gl.SamplerParameterf(name, GL_TEXTURE_MAX_LOD, desc.max_level);
  if (desc.max_anisotropy > 1.0f && context->max_anisotropy() > 1.0f)
    gl.SamplerParameterf(name, GL_TEXTURE_MAX_ANISOTROPY_EXT,
                         std::min(desc.max_anisotropy, context->max_anisotropy()));
  context->label(GL_SAMPLER, name, describe(desc));
  context->check("creating a sampler");
  ++context->counters.created;
}

GlSampler::~GlSampler() {
  try {
    context->gl().DeleteSamplers(1, &name);
  } catch (const Error&) {
    // As in ~GlBuffer.
  }
}

GlBuffer& of(const BufferRef& buffer, std::string_view what) {
  if (!buffer) throw Error(ExitCode::internal, std::string(what), "is given no buffer");
  return static_cast<GlBuffer&>(*buffer);
}

GlTexture& of(const TextureRef& texture, std::string_view what) {
  if (!texture) throw Error(ExitCode::internal, std::string(what), "is given no texture");
  return static_cast<GlTexture&>(*texture);
}

} // namespace gg::gpu::opengl
