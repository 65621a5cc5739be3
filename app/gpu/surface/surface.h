// Where an OpenGL context comes from when there is no window: EGL or OSMesa. Both libraries are
// opened at run time, so that a machine that lacks one gets a sentence instead of a loader's error.
#pragma once

#include <memory>
#include <string>
#include <vector>

namespace gg::gpu::surface {

using Proc = void (*)();

// An OpenGL 4.5 core context that draws into framebuffer objects only.
class Context {
public:
  virtual ~Context() = default;
  Context() = default;
  Context(const Context&) = delete;
  Context& operator=(const Context&) = delete;

  // Makes this the thread's context unless it is already; the one before is released first, because
  // EGL and OSMesa do not know of each other. Throws Error(device) if the context is in use on
  // another thread.
  void make_current();
  // Address of a GL function, or nullptr.
  virtual Proc proc(const char* name) const = 0;

protected:
  // To be called by destructors: afterwards this is no thread's context.
  void leave() noexcept;

private:
  virtual bool bind() = 0;
  virtual void unbind() noexcept = 0;
};

// A way to get a context through EGL.
struct EglChoice {
  int device = -1; // in the order of EGL's own list; -1: Mesa without any device (surfaceless)
  bool software = false;
};

// What EGL offers, without opening any of it; empty if there is no EGL.
std::vector<EglChoice> egl_choices();

// Throw Error(device) saying what is missing and what to install.
std::unique_ptr<Context> open_egl(const EglChoice& choice, bool debug);
std::unique_ptr<Context> open_osmesa();

} // namespace gg::gpu::surface
