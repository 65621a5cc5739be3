// Which method draws, and who decides: --method auto measures (auto_method.h), a name stands for itself.
#pragma once

#include "commands/options.h"

#include <functional>

namespace gg::commands {

struct ChosenMethod {
  NamedMethod named;
  bool within_limit = true; // false: --method auto found none that is, and this comes nearest
};

using MethodChoice =
    std::function<ChosenMethod(const SceneOptions&, const DeviceOptions&, const MethodOptions&)>;

} // namespace gg::commands
