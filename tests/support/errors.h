// Errors as a person sees them.
#pragma once

#include "core/error.h"

#include <gtest/gtest.h>

#include <functional>
#include <string>
#include <vector>

namespace gg::test {

// Success if `act` throws a gg::Error with this code whose text contains every one of `parts` (the
// file, the place, what is wrong, the remedy).
::testing::AssertionResult fails_with(ExitCode code, const std::vector<std::string>& parts,
                                      const std::function<void()>& act);

} // namespace gg::test
