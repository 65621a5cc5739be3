// How long passes take on the device, by timestamps.
#pragma once

#include "gpu/opengl/context.h"

#include <vector>

namespace gg::gpu::opengl {

class Timers {
public:
  explicit Timers(ContextRef context);
  ~Timers();
  Timers(const Timers&) = delete;
  Timers& operator=(const Timers&) = delete;

  void stamp(); // now, in the order of the device's work
  // Waits, appends the times between stamps 0 and 1, 2 and 3, ... and forgets them.
  void collect(std::span<const Pass> passes, std::vector<PassTime>& times);
  void discard() { used_ = 0; }

private:
  ContextRef context_;
  bool software_;
  std::vector<GLuint> queries_;
  std::size_t used_ = 0;
};

} // namespace gg::gpu::opengl
