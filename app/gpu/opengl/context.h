// What every object of a device shares and keeps alive: the OpenGL context, its limits, what went
// wrong in it, and how much memory is held.
#pragma once

#include "gpu/checks.h"
#include "gpu/opengl/framebuffers.h"
#include "gpu/opengl/gl.h"
#include "gpu/surface/surface.h"

#include <memory>
#include <string>
#include <string_view>

namespace gg::gpu::opengl {

// Whether a renderer that calls itself so runs on the CPU.
bool is_software(std::string_view renderer);

class Context {
public:
  // Throws Error(device) if the context is older than 4.5 or takes no SPIR-V.
  Context(std::unique_ptr<surface::Context> surface, bool debug);
  ~Context();
  Context(const Context&) = delete;
  Context& operator=(const Context&) = delete;

  // The functions of this context, which is current on this thread from now on.
  const GladGLContext& gl() {
    surface_->make_current();
    return gl_;
  }
  const Limits& limits() const { return limits_; }
  float max_anisotropy() const { return max_anisotropy_; }
  std::string renderer() const;
  std::string version() const;

  // Names an object, so that debuggers and the driver's messages show it.
  void label(GLenum kind, GLuint object, std::string_view text);

  // Throws Error(device) naming `doing` and the driver's messages, if it has reported an error (in
  // a debug context: anything but advice) since the last call.
  void check(const std::string& doing);

  // Grows with every object whose state is cached: two objects never have the same serial, although
  // OpenGL uses a name again after its object is gone.
  std::uint64_t next_serial() { return ++serial_; }

  // Shader writes are numbered; one that is newer than the last barrier may not be visible yet.
  std::uint64_t writes = 0, visible_writes = 0;
  void make_visible(std::uint64_t write); // a barrier, if there has been none since

  Framebuffers framebuffers;
  DeviceCounters counters;
  std::size_t held_bytes = 0; // by buffers and textures that are alive

private:
  static void GLAD_API_PTR on_message(GLenum source, GLenum type, GLuint id, GLenum severity,
                                      GLsizei length, const GLchar* text, const void* user);
  void set_conventions(bool debug);
  void read_limits();

  std::unique_ptr<surface::Context> surface_;
  GladGLContext gl_{};
  Limits limits_;
  float max_anisotropy_ = 1.0f;
  int label_length_ = 0;
  std::string messages_;
  std::uint64_t serial_ = 0;
};
using ContextRef = std::shared_ptr<Context>;

} // namespace gg::gpu::opengl
