// The part of GlEncoder that gives a pipeline's resources to OpenGL.
#include "gpu/opengl/encoder.h"
#include "gpu/opengl/formats.h"

namespace gg::gpu::opengl {

using shaders::Kind;

void GlEncoder::bind(const Slot& slot, const Bound& bound) {
  switch (slot.binding.kind) {
  case Kind::uniform_block:
  case Kind::storage_block:
    return bind_buffer(slot, bound);
  case Kind::sampled:
    return bind_texture(slot, bound);
  case Kind::image:
    return bind_image(slot, bound);
  }
}

// Notes what a unit is to hold; false if it holds that already.
bool GlEncoder::unit_changes(const Slot& slot, const Unit& wanted) {
  std::vector<Unit>& units = units_[static_cast<std::size_t>(slot.binding.kind)];
  if (units.size() <= slot.unit) units.resize(slot.unit + 1);
  if (units[slot.unit] == wanted) return false;
  units[slot.unit] = wanted;
  return true;
}

void GlEncoder::bind_buffer(const Slot& slot, const Bound& bound) {
  const auto& buffer = static_cast<const GlBuffer&>(*bound.buffer);
  const bool storage = slot.binding.kind == Kind::storage_block;
  check_block(slot, bound, buffer.written != 0);
  // A range of a uniform buffer ends with the block: what follows may be longer than OpenGL allows.
  const std::size_t bytes = storage ? bound.bytes : slot.binding.bytes;
  if (unit_changes(slot, {buffer.serial, 0, bound.offset, bytes}))
    gl_.BindBufferRange(storage ? GL_SHADER_STORAGE_BUFFER : GL_UNIFORM_BUFFER, slot.unit,
                        buffer.name, static_cast<GLintptr>(bound.offset),
                        static_cast<GLsizeiptr>(bytes));
}

void GlEncoder::bind_texture(const Slot& slot, const Bound& bound) {
  check_view_of(slot, bound);
  auto& texture = static_cast<GlTexture&>(*bound.view.texture);
  const auto& sampler = static_cast<const GlSampler&>(*bound.sampler);
  const GlTexture::Handle handle = texture.handle(bound.view, slot.binding.shape);
  if (!unit_changes(slot, {handle.serial, sampler.serial, 0, 0})) return;
  gl_.BindTextureUnit(slot.unit, handle.name);
  gl_.BindSampler(slot.unit, sampler.name);
}

void GlEncoder::bind_image(const Slot& slot, const Bound& bound) {
  check_view_of(slot, bound);
  auto& texture = static_cast<GlTexture&>(*bound.view.texture);
  const View& view = bound.view;
  const GLenum access = !slot.binding.writes  ? GL_READ_ONLY
                        : !slot.binding.reads ? GL_WRITE_ONLY
                                              : GL_READ_WRITE;
  const GLenum format = names(texture.desc.format).internal;
  // One layer, or all of a volume, is asked for of the texture itself; several layers need a view.
  const bool one = slot.binding.shape == Shape::d2;
  const bool all = view.layer == 0 && view.layer_count == extent(texture.desc, view.level).layers;
  if (one || all) {
    const auto layer = static_cast<std::size_t>(view.layer);
    if (unit_changes(slot,
                     {texture.serial, one ? 1u : 0u, static_cast<std::size_t>(view.level), layer}))
      gl_.BindImageTexture(slot.unit, texture.name, view.level, one ? GL_FALSE : GL_TRUE,
                           view.layer, access, format);
    return;
  }
  const GlTexture::Handle handle = texture.handle(view, slot.binding.shape);
  if (unit_changes(slot, {handle.serial, 0, 0, 0}))
    gl_.BindImageTexture(slot.unit, handle.name, 0, GL_TRUE, 0, access, format);
}

} // namespace gg::gpu::opengl
