#include "gpu/surface/lost_display.h"

#include "core/clean_up.h"

#include <dlfcn.h>

#include <cstdio>

namespace gg::gpu::surface {
namespace {

// Xlib does not let this return (XSetIOErrorHandler(3)), and destructors would call Xlib again.
int on_lost(void* /* the connection */) {
  std::fputs("groundglass: window: the display has ended the connection. Open it again; "
             "groundglass capture draws without a window.\n",
             stderr);
  clean_up_and_exit(ExitCode::device);
}

} // namespace

void exit_when_the_display_is_lost() {
  using Handler = int (*)(void*);
  void* xlib = ::dlopen("libX11.so.6", RTLD_LAZY | RTLD_NOLOAD); // the one that GLFW has opened
  if (!xlib) return;
  const auto set_handler =
      reinterpret_cast<Handler (*)(Handler)>(::dlsym(xlib, "XSetIOErrorHandler"));
  if (set_handler) set_handler(on_lost);
  ::dlclose(xlib); // GLFW keeps it
}

} // namespace gg::gpu::surface
