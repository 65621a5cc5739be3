#include "viewer/history.h"

namespace gg::viewer {
namespace {

// Trailing empty edits say nothing.
Edits trimmed(Edits edits) {
  while (!edits.empty() && edits.back().empty())
    edits.pop_back();
  return edits;
}

} // namespace

void History::note(const Edits& edits) {
  Edits now = trimmed(edits);
  if (now == states_[at_]) return;
  states_.resize(at_ + 1);
  states_.push_back(std::move(now));
  ++at_;
}

} // namespace gg::viewer
