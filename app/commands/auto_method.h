// --method auto: which method the scene at hand is best drawn with, found by measuring.
#pragma once

#include "commands/chosen_method.h"

namespace gg::commands {

// The method that --method names. For `auto`: all methods are timed on the scene at its full size,
// one sample per pixel, and their errors measured against a truth of a small picture of it
// (`measured_side` pixels at the most, `measured_samples` samples per pixel); then the fastest
// within --max-error or the most accurate within --budget is taken, or the nearest if none is, and
// said on stderr. What was measured is kept in $XDG_CACHE_HOME/groundglass/auto or
// ~/.cache/groundglass/auto: the next call with the same scene, options, device and program costs
// nothing. Throws Error(usage) if limits and method do not go together, Error(interrupted).
ChosenMethod choose_method(const SceneOptions& scene, const DeviceOptions& device,
                           const MethodOptions& method);

inline constexpr int measured_side = 256;
inline constexpr long measured_samples = 64;

} // namespace gg::commands
