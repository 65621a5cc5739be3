#include "viewer/warmup.h"

#include <utility>

namespace gg::viewer {

void Warmup::plan(std::vector<WarmupFrame> frames) {
  pause();
  // Its pipelines may be made, and not drawn with yet.
  if (looked_at_ && !frames_.empty()) {
    frames_.front().draw = true;
    frames.insert(frames.begin(), std::move(frames_.front()));
  }
  frames_.assign(frames.begin(), frames.end());
  begin();
}

void Warmup::forget() {
  pause();
  frames_.clear();
  begin();
}

void Warmup::next() {
  pause();
  frames_.pop_front();
  begin();
}

void Warmup::begin() {
  pipelines_.clear();
  looked_at_ = false;
  pass_ = 0;
}

void Warmup::pause() {
  if (set_) picture_.set_seen();
  set_ = false;
}

void Warmup::advance() {
  WarmupFrame& frame = frames_.front();
  if (!looked_at_) {
    pause(); // it looks at the picture's own scene
    pipelines_ = picture_.missing(frame.desc, frame.materials.get());
    looked_at_ = true;
    if (pipelines_.empty() && !frame.draw) next();
    return;
  }
  if (!pipelines_.empty()) {
    picture_.make(pipelines_.back());
    pipelines_.pop_back();
    return;
  }
  if (!set_) {
    picture_.set_unseen(frame.desc, frame.materials.get());
    set_ = true;
    return;
  }
  picture_.draw_unseen(pass_);
  if (++pass_ >= picture_.unseen_passes()) next();
}

} // namespace gg::viewer
