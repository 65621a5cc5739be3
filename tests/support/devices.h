// Devices that the tests of a process share.
#pragma once

#include "gpu/device.h"

namespace gg::test {

// The device of this backend and surface, its driver's messages turned into errors; made at the first call. It ends with
// the last test, before the process does: a driver that is still at work, or that cleaned up first, may crash an exit.
gpu::Device& shared_device(gpu::Backend backend, gpu::Surface surface);

} // namespace gg::test
