// How long passes take on the device.
#pragma once

#include "gpu/vulkan/context.h"

#include <span>
#include <vector>

namespace gg::gpu::vulkan {

class Timers {
public:
  explicit Timers(Context& context) : context_(context) {}
  ~Timers();
  Timers(const Timers&) = delete;
  Timers& operator=(const Timers&) = delete;

  // Room for `count` stamps; earlier ones, which have been collected, are forgotten. Throws
  // Error(device) if the device has no clock.
  void restart(VkCommandBuffer commands, std::uint32_t count);
  void stamp(VkCommandBuffer commands); // when everything before it is done
  // Two stamps per pass, after the submission is done.
  void collect(std::span<const Pass> passes, std::vector<PassTime>& times);

private:
  Context& context_;
  VkQueryPool pool_ = VK_NULL_HANDLE;
  std::uint32_t size_ = 0, used_ = 0;
};

} // namespace gg::gpu::vulkan
