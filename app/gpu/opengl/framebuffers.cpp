#include "gpu/opengl/framebuffers.h"

#include "core/error.h"
#include "gpu/opengl/context.h"

#include <algorithm>

namespace gg::gpu::opengl {
namespace {

void attach(const GladGLContext& gl, GLuint framebuffer, GLenum point, const Attachment& to) {
  if (to.layered)
    gl.NamedFramebufferTextureLayer(framebuffer, point, to.texture, to.level, to.layer);
  else
    gl.NamedFramebufferTexture(framebuffer, point, to.texture, to.level);
}

} // namespace

GLuint Framebuffers::find_or_make(Context& context, const std::vector<Attachment>& colors,
                                  const Attachment& depth, const std::string& label) {
  const auto known = std::ranges::find_if(
      entries_, [&](const Entry& e) { return e.depth == depth && e.colors == colors; });
  if (known != entries_.end()) return known->name;

  const GladGLContext& gl = context.gl();
  GLuint name = 0;
  gl.CreateFramebuffers(1, &name);
  entries_.push_back({colors, depth, name});
  context.label(GL_FRAMEBUFFER, name, label);
  ++context.counters.created;
  std::vector<GLenum> draw;
  for (const Attachment& color : colors) {
    draw.push_back(GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(draw.size()));
    attach(gl, name, draw.back(), color);
  }
  if (depth.texture) attach(gl, name, GL_DEPTH_ATTACHMENT, depth);
  gl.NamedFramebufferDrawBuffers(name, static_cast<GLsizei>(draw.size()), draw.data());
  const GLenum status = gl.CheckNamedFramebufferStatus(name, GL_DRAW_FRAMEBUFFER);
  if (status != GL_FRAMEBUFFER_COMPLETE)
    throw Error(ExitCode::device, "OpenGL",
                "its driver cannot draw into this combination of targets (status "
                    + std::to_string(status) + ")");
  return name;
}

void Framebuffers::forget(const GladGLContext& gl, std::uint64_t texture_serial) {
  std::erase_if(entries_, [&](const Entry& entry) {
    const bool uses =
        entry.depth.texture_serial == texture_serial
        || std::ranges::find(entry.colors, texture_serial, &Attachment::texture_serial)
               != entry.colors.end();
    if (uses) gl.DeleteFramebuffers(1, &entry.name);
    return uses;
  });
}

void Framebuffers::clear(const GladGLContext& gl) {
  for (const Entry& entry : entries_)
    gl.DeleteFramebuffers(1, &entry.name);
  entries_.clear();
}

} // namespace gg::gpu::opengl
