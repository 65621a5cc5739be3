// Undo and redo of what was done to materials.
#pragma once

#include "viewer/view.h"

#include <vector>

namespace gg::viewer {

using Edits = std::vector<Edit>;

class History {
public:
  // The edits as they are when no control is held: a new state if they differ from the last.
  void note(const Edits& edits);
  bool can_undo() const { return at_ > 0; }
  bool can_redo() const { return at_ + 1 < states_.size(); }
  const Edits& now() const { return states_[at_]; }
  const Edits& undo() { return states_[can_undo() ? --at_ : at_]; }
  const Edits& redo() { return states_[can_redo() ? ++at_ : at_]; }

private:
  std::vector<Edits> states_{Edits{}};
  std::size_t at_ = 0;
};

} // namespace gg::viewer
