// The end of a display that windows are open on.
#pragma once

namespace gg::gpu::surface {

// Where the X server ends the connection, the process ends with ExitCode::device and a message; Xlib's own handler exits with 1, which
// means a fault of ours. Call it when GLFW has been started; without X11 nothing is done.
void exit_when_the_display_is_lost();

} // namespace gg::gpu::surface
