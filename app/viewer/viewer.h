// The interactive viewer: one window, its loop, and what hangs together in it.
#pragma once

#include "gpu/window.h"
#include "viewer/debug_view.h"
#include "viewer/view.h"

#include <string>

namespace gg::viewer {

struct Settings {
  View view;
  gpu::WindowDesc window;
  double frames_per_second = 30.0; // wanted while something moves
  bool standard_in_motion = true;  // where the method would miss half of that rate
  bool panel = true;
  // Without hands: any of these draws what it is to and ends.
  int bench_orbit = 0;           // frames of one turn about the scene, timed
  std::string screenshot_window; // a picture of the whole window when everything in it is finished
  std::string pick;              // the object of this name, to begin with
  std::optional<glm::vec2> inspect;     // the lobes there, 0..1 from the top left of the picture
  long truth = 0;                       // samples per pixel of a truth shown from the start
  std::string second;                   // a method that stands in the truth's place from the start
  DebugKind debug = DebugKind::picture; // what is shown to begin with
  std::string comparing = "wipe";       // how: wipe, side-by-side, error, flip
};

// Returns when the window is closed. Throws Error: of the first scene, the window, or a result that cannot be written; later errors
// are shown in the window.
void run(const Settings& settings, const Commands& commands);

} // namespace gg::viewer
