// Frames that are likely next, drawn where nobody sees them while nothing else is to be done: what they need is then made, and the
// first turn of the camera or of a slider does not wait for it.
#pragma once

#include "viewer/picture.h"

#include <deque>
#include <memory>
#include <vector>

namespace gg::viewer {

struct WarmupFrame {
  frame::FrameDesc desc;
  std::shared_ptr<const Picture::Materials> materials; // null: the scene's
  bool draw = false; // in any case; else only if it wants a pipeline that is not there
};

class Warmup {
public:
  explicit Warmup(Picture& picture) : picture_(picture) {}

  // The frames from now on, the likeliest first, in place of what was not done yet. The picture has been drawn.
  void plan(std::vector<WarmupFrame> frames);
  void forget(); // another scene or other shaders are to be drawn
  bool done() const { return frames_.empty(); }
  // One step: the plan of a frame, a pipeline, or a pass.
  void advance();
  // Before anything else is done with the picture. What is under way goes on at the next step.
  void pause();

private:
  void next();
  void begin(); // of the first frame nothing is known or made

  Picture& picture_;
  std::deque<WarmupFrame> frames_;           // the one under way first
  std::vector<gpu::PipelineDesc> pipelines_; // to be made for it
  bool looked_at_ = false;                   // it is known which
  bool set_ = false;                         // the picture is set to it
  std::size_t pass_ = 0;                     // of it, to be drawn next
};

} // namespace gg::viewer
