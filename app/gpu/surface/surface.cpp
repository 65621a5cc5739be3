#include "gpu/surface/surface.h"

#include "core/error.h"

namespace gg::gpu::surface {
namespace {

thread_local Context* current = nullptr;

} // namespace

void Context::make_current() {
  if (current == this) return;
  if (current) current->unbind();
  current = nullptr;
  if (!bind())
    throw Error(ExitCode::device, "OpenGL", "its context cannot be made current",
                "Use a device on one thread at a time, the one that created it.");
  current = this;
}

void Context::leave() noexcept {
  if (current != this) return;
  unbind();
  current = nullptr;
}

} // namespace gg::gpu::surface
