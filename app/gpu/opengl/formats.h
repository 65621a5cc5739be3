// Formats in OpenGL's words.
#pragma once

#include "gpu/opengl/gl.h"
#include "gpu/types.h"

namespace gg::gpu::opengl {

struct FormatNames {
  GLenum internal = GL_NONE; // how it is stored
  GLenum format = GL_NONE;   // the channels that are transferred
  GLenum type = GL_NONE;     // of each channel
};
FormatNames names(Format format);

GLenum target(Shape shape);
GLenum name(Compare compare);
GLenum name(Filter filter);
GLenum name(Filter filter, Filter between_levels);
GLenum name(Wrap wrap);

} // namespace gg::gpu::opengl
