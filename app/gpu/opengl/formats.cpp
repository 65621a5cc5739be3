#include "gpu/opengl/formats.h"

namespace gg::gpu::opengl {

FormatNames names(Format format) {
  switch (format) {
  case Format::none:
    break;
  case Format::r8:
    return {GL_R8, GL_RED, GL_UNSIGNED_BYTE};
  case Format::rg8:
    return {GL_RG8, GL_RG, GL_UNSIGNED_BYTE};
  case Format::rgba8:
    return {GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE};
  case Format::rgba8_srgb:
    return {GL_SRGB8_ALPHA8, GL_RGBA, GL_UNSIGNED_BYTE};
  case Format::r16f:
    return {GL_R16F, GL_RED, GL_HALF_FLOAT};
  case Format::rg16f:
    return {GL_RG16F, GL_RG, GL_HALF_FLOAT};
  case Format::rgba16f:
    return {GL_RGBA16F, GL_RGBA, GL_HALF_FLOAT};
  case Format::r32f:
    return {GL_R32F, GL_RED, GL_FLOAT};
  case Format::rg32f:
    return {GL_RG32F, GL_RG, GL_FLOAT};
  case Format::rgba32f:
    return {GL_RGBA32F, GL_RGBA, GL_FLOAT};
  case Format::r32ui:
    return {GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT};
  case Format::rg32ui:
    return {GL_RG32UI, GL_RG_INTEGER, GL_UNSIGNED_INT};
  case Format::rgba32ui:
    return {GL_RGBA32UI, GL_RGBA_INTEGER, GL_UNSIGNED_INT};
  case Format::depth32f:
    return {GL_DEPTH_COMPONENT32F, GL_DEPTH_COMPONENT, GL_FLOAT};
  }
  return {};
}

GLenum target(Shape shape) {
  switch (shape) {
  case Shape::d2:
    return GL_TEXTURE_2D;
  case Shape::d2_array:
    return GL_TEXTURE_2D_ARRAY;
  case Shape::d3:
    return GL_TEXTURE_3D;
  case Shape::cube:
    return GL_TEXTURE_CUBE_MAP;
  case Shape::cube_array:
    return GL_TEXTURE_CUBE_MAP_ARRAY;
  }
  return GL_NONE;
}

GLenum name(Compare compare) {
  switch (compare) {
  case Compare::never:
    return GL_NEVER;
  case Compare::less:
    return GL_LESS;
  case Compare::equal:
    return GL_EQUAL;
  case Compare::less_equal:
    return GL_LEQUAL;
  case Compare::greater:
    return GL_GREATER;
  case Compare::greater_equal:
    return GL_GEQUAL;
  case Compare::always:
    return GL_ALWAYS;
  }
  return GL_NONE;
}

GLenum name(Filter filter) {
  return filter == Filter::nearest ? GL_NEAREST : GL_LINEAR;
}

GLenum name(Filter filter, Filter between_levels) {
  const bool nearest = filter == Filter::nearest;
  return between_levels == Filter::nearest
             ? (nearest ? GL_NEAREST_MIPMAP_NEAREST : GL_LINEAR_MIPMAP_NEAREST)
             : (nearest ? GL_NEAREST_MIPMAP_LINEAR : GL_LINEAR_MIPMAP_LINEAR);
}

GLenum name(Wrap wrap) {
  switch (wrap) {
  case Wrap::repeat:
    return GL_REPEAT;
  case Wrap::mirrored_repeat:
    return GL_MIRRORED_REPEAT;
  case Wrap::clamp:
    return GL_CLAMP_TO_EDGE;
  }
  return GL_NONE;
}

} // namespace gg::gpu::opengl
