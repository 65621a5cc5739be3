#include "core/error.h"
#include "gpu/opengl/formats.h"
#include "gpu/opengl/resources.h"

#include <algorithm>

namespace gg::gpu::opengl {
namespace {

bool is_flat(Shape shape) {
  return shape == Shape::d2;
}

} // namespace

GlTexture::GlTexture(ContextRef owner, const TextureDesc& what)
    : context(std::move(owner)), serial(context->next_serial()) {
  desc = what;
  const GladGLContext& gl = context->gl();
  const GLenum internal = names(desc.format).internal;
  gl.CreateTextures(target(desc.shape), 1, &name);
  if (desc.shape == Shape::d2 || desc.shape == Shape::cube)
    gl.TextureStorage2D(name, desc.levels, internal, desc.width, desc.height);
  else
    gl.TextureStorage3D(name, desc.levels, internal, desc.width, desc.height,
                        extent(desc, 0).layers);
  context->label(GL_TEXTURE, name, desc.label);
  try {
    context->check("creating " + describe(desc));
  } catch (...) {
    gl.DeleteTextures(1, &name);
    throw;
  }
  context->held_bytes += bytes(desc);
  ++context->counters.created;
}

GlTexture::~GlTexture() {
  context->held_bytes -= bytes(desc);
  try {
    const GladGLContext& gl = context->gl();
    context->framebuffers.forget(gl, serial);
    for (const CachedView& view : views_)
      gl.DeleteTextures(1, &view.handle.name);
    gl.DeleteTextures(1, &name);
  } catch (const Error&) {
    // Not reachable from this thread: the context takes it along when it ends.
  }
}

GlTexture::Handle GlTexture::handle(const View& view, Shape shape) {
  if (shape == desc.shape && view.level == 0 && view.level_count == desc.levels && view.layer == 0
      && view.layer_count == extent(desc, 0).layers)
    return {name, serial};
  CachedView wanted{shape, view.level, view.level_count, view.layer, view.layer_count, {}};
  const auto known = std::ranges::find(views_, wanted);
  if (known != views_.end()) return known->handle;

  // A volume's slices are not layers: its view has all of them.
  const bool volume = desc.shape == Shape::d3;
  const GladGLContext& gl = context->gl();
  gl.GenTextures(1, &wanted.handle.name); // a view takes a name that has never been bound
  wanted.handle.serial = context->next_serial();
  gl.TextureView(wanted.handle.name, target(shape), name, names(desc.format).internal,
                 static_cast<GLuint>(view.level), static_cast<GLuint>(view.level_count),
                 volume ? 0 : static_cast<GLuint>(view.layer),
                 volume ? 1 : static_cast<GLuint>(view.layer_count));
  views_.push_back(wanted);
  ++context->counters.created;
  context->label(GL_TEXTURE, wanted.handle.name, desc.label + " (part)");
  context->check("viewing " + describe(desc));
  return wanted.handle;
}

Attachment GlTexture::attachment(const View& view) const {
  return {serial, name, view.level, view.layer, !is_flat(desc.shape)};
}

void GlTexture::upload(int level, int layer, std::span<const std::byte> texels) {
  const GladGLContext& gl = context->gl();
  const FormatNames format = names(desc.format);
  const Extent size = extent(desc, level);
  context->make_visible(written);
  if (is_flat(desc.shape))
    gl.TextureSubImage2D(name, level, 0, 0, size.width, size.height, format.format, format.type,
                         texels.data());
  else
    gl.TextureSubImage3D(name, level, 0, 0, layer, size.width, size.height, 1, format.format,
                         format.type, texels.data());
  context->check("filling " + describe(desc));
}

std::vector<std::byte> GlTexture::read(int level, int layer) {
  const GladGLContext& gl = context->gl();
  const FormatNames format = names(desc.format);
  const Extent size = extent(desc, level);
  std::vector<std::byte> texels(static_cast<std::size_t>(size.width)
                                * static_cast<std::size_t>(size.height)
                                * bytes_per_texel(desc.format));
  context->make_visible(written);
  gl.GetTextureSubImage(name, level, 0, 0, is_flat(desc.shape) ? 0 : layer, size.width, size.height,
                        1, format.format, format.type, static_cast<GLsizei>(texels.size()),
                        texels.data());
  context->check("reading " + describe(desc));
  return texels;
}

} // namespace gg::gpu::opengl
