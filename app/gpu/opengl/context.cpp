#include "gpu/opengl/context.h"

#include "core/error.h"

#include <algorithm>

namespace gg::gpu::opengl {
namespace {

int integer(const GladGLContext& gl, GLenum what) {
  GLint value = 0;
  gl.GetIntegerv(what, &value);
  return value;
}

std::string text(const GladGLContext& gl, GLenum what) {
  const GLubyte* string = gl.GetString(what);
  return string ? reinterpret_cast<const char*>(string) : "";
}

const char* error_name(GLenum error) {
  switch (error) {
  case GL_INVALID_ENUM:
    return "GL_INVALID_ENUM";
  case GL_INVALID_VALUE:
    return "GL_INVALID_VALUE";
  case GL_INVALID_OPERATION:
    return "GL_INVALID_OPERATION";
  case GL_INVALID_FRAMEBUFFER_OPERATION:
    return "GL_INVALID_FRAMEBUFFER_OPERATION";
  case GL_OUT_OF_MEMORY:
    return "out of memory";
  case GL_CONTEXT_LOST:
    return "the device was lost";
  default:
    return "an unknown error";
  }
}

} // namespace

bool is_software(std::string_view renderer) {
  for (const char* known : {"llvmpipe", "softpipe", "SWR", "SwiftShader"})
    if (renderer.find(known) != std::string_view::npos) return true;
  return false;
}

Context::Context(std::unique_ptr<surface::Context> surface, bool debug)
    : surface_(std::move(surface)) {
  surface_->make_current();
  const auto load = [](void* from, const char* name) -> GLADapiproc {
    return static_cast<const surface::Context*>(from)->proc(name);
  };
  const int version = gladLoadGLContextUserPtr(&gl_, load, surface_.get());
  if (version < GLAD_MAKE_VERSION(4, 5))
    throw Error(ExitCode::device, "OpenGL", "its version is older than 4.5",
                "Update the driver, or choose another --device or --surface.");
  if (!gl_.ARB_gl_spirv)
    throw Error(ExitCode::device, renderer(), "its driver lacks GL_ARB_gl_spirv",
                "Update the driver, or choose another --device or --surface.");
  read_limits();
  set_conventions(debug);
  check("setting up");
}

Context::~Context() {
  try {
    framebuffers.clear(gl());
  } catch (const Error&) {
    // The context cannot be reached from this thread; it takes its objects with it.
  }
}

void Context::read_limits() {
  limits_.texture_2d = integer(gl_, GL_MAX_TEXTURE_SIZE);
  limits_.texture_3d = integer(gl_, GL_MAX_3D_TEXTURE_SIZE);
  limits_.texture_cube = integer(gl_, GL_MAX_CUBE_MAP_TEXTURE_SIZE);
  limits_.array_layers = integer(gl_, GL_MAX_ARRAY_TEXTURE_LAYERS);
  limits_.uniform_bytes = static_cast<std::size_t>(integer(gl_, GL_MAX_UNIFORM_BLOCK_SIZE));
  GLint64 storage = 0;
  gl_.GetInteger64v(GL_MAX_SHADER_STORAGE_BLOCK_SIZE, &storage);
  limits_.storage_bytes = static_cast<std::size_t>(storage);
  limits_.attachments = integer(gl_, GL_MAX_COLOR_ATTACHMENTS);
  limits_.groups = ~0u;
  for (GLuint axis = 0; axis < 3; ++axis) {
    GLint groups = 0;
    gl_.GetIntegeri_v(GL_MAX_COMPUTE_WORK_GROUP_COUNT, axis, &groups);
    limits_.groups = std::min(limits_.groups, static_cast<unsigned>(groups));
  }
  label_length_ = integer(gl_, GL_MAX_LABEL_LENGTH);
  if (gl_.EXT_texture_filter_anisotropic)
    gl_.GetFloatv(GL_MAX_TEXTURE_MAX_ANISOTROPY_EXT, &max_anisotropy_);
}

// The conventions of gpu/types.h, where OpenGL's own differ.
void Context::set_conventions(bool debug) {
  // Clip-space y = 1 goes to row 0, the first row in memory and the top of a picture.
  gl_.ClipControl(GL_UPPER_LEFT, GL_ZERO_TO_ONE);
  gl_.Enable(GL_TEXTURE_CUBE_MAP_SEAMLESS);
  gl_.Enable(GL_FRAMEBUFFER_SRGB); // what is drawn into an sRGB format is encoded
  gl_.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
  gl_.PixelStorei(GL_PACK_ALIGNMENT, 1);
  gl_.FrontFace(GL_CCW);
  if (!debug) return;
  gl_.Enable(GL_DEBUG_OUTPUT);
  gl_.Enable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
  gl_.DebugMessageControl(GL_DONT_CARE, GL_DONT_CARE, GL_DONT_CARE, 0, nullptr, GL_TRUE);
  gl_.DebugMessageCallback(on_message, this);
}

void Context::on_message(GLenum, GLenum type, GLuint, GLenum, GLsizei, const GLchar* text,
                         const void* user) {
  // Advice about speed, statistics and our own groups are not faults.
  if (type != GL_DEBUG_TYPE_ERROR && type != GL_DEBUG_TYPE_UNDEFINED_BEHAVIOR
      && type != GL_DEBUG_TYPE_DEPRECATED_BEHAVIOR && type != GL_DEBUG_TYPE_PORTABILITY)
    return;
  auto* self = static_cast<Context*>(const_cast<void*>(user));
  std::string& all = self->messages_;
  all += (all.empty() ? "" : "; ") + std::string(text);
  while (!all.empty() && all.back() == '\n')
    all.pop_back();
}

void Context::check(const std::string& doing) {
  std::string what = std::move(messages_);
  messages_.clear();
  bool memory = false;
  while (const GLenum error = gl().GetError()) {
    memory |= error == GL_OUT_OF_MEMORY;
    if (what.empty() || error == GL_OUT_OF_MEMORY)
      what += (what.empty() ? "" : "; ") + std::string(error_name(error));
    if (error == GL_CONTEXT_LOST) break; // reported for ever
  }
  if (what.empty()) return;
  throw Error(ExitCode::device, doing, what,
              memory ? "Use a smaller picture, scene or environment, or another --device." : "");
}

void Context::label(GLenum kind, GLuint object, std::string_view text) {
  const auto longest = static_cast<std::size_t>(label_length_ - 1);
  gl().ObjectLabel(kind, object, static_cast<GLsizei>(std::min(text.size(), longest)), text.data());
}

void Context::make_visible(std::uint64_t write) {
  if (write <= visible_writes) return;
  gl().MemoryBarrier(GL_ALL_BARRIER_BITS);
  visible_writes = writes;
}

std::string Context::renderer() const {
  return text(gl_, GL_RENDERER);
}

std::string Context::version() const {
  return text(gl_, GL_VERSION);
}

} // namespace gg::gpu::opengl
