// Ctrl-C as a request: work that keeps what it has asks whether to stop.
#pragma once

namespace gg::truth {

// While one exists, the first SIGINT or SIGTERM only sets requested(); a second one does what it
// would have done without this object. One at a time.
class Interruptible {
public:
  Interruptible();
  ~Interruptible();
  Interruptible(const Interruptible&) = delete;
  Interruptible& operator=(const Interruptible&) = delete;

  static bool requested();
};

} // namespace gg::truth
