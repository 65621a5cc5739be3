#include "gpu/vulkan/timers.h"

namespace gg::gpu::vulkan {

Timers::~Timers() {
  if (pool_) context_.vk().DestroyQueryPool(context_.device(), pool_, nullptr);
}

void Timers::restart(VkCommandBuffer commands, std::uint32_t count) {
  const Adapter& adapter = context_.adapter();
  if (adapter.abilities.queues[adapter.queue_family].timestampValidBits == 0)
    throw Error(ExitCode::device, "vulkan", adapter.info.name + " cannot time what it does",
                "Choose another --device or --backend opengl");
  if (count > size_) {
    if (pool_)
      context_.retire([&shared = context_, pool = pool_] {
        shared.vk().DestroyQueryPool(shared.device(), pool, nullptr);
      });
    pool_ = VK_NULL_HANDLE, size_ = 0;
    const VkQueryPoolCreateInfo info{.sType = VK_STRUCTURE_TYPE_QUERY_POOL_CREATE_INFO,
                                     .queryType = VK_QUERY_TYPE_TIMESTAMP,
                                     .queryCount = count};
    check(context_.vk().CreateQueryPool(context_.device(), &info, nullptr, &pool_),
          "creating timers");
    size_ = count;
    ++context_.counters.created;
    context_.name(VK_OBJECT_TYPE_QUERY_POOL, pool_, "timers");
  }
  used_ = 0;
  context_.vk().CmdResetQueryPool(commands, pool_, 0, size_);
}

void Timers::stamp(VkCommandBuffer commands) {
  context_.vk().CmdWriteTimestamp2(commands, VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT, pool_, used_++);
}

void Timers::collect(std::span<const Pass> passes, std::vector<PassTime>& times) {
  std::vector<std::uint64_t> ticks(used_);
  check(context_.vk().GetQueryPoolResults(
            context_.device(), pool_, 0, used_, ticks.size() * sizeof ticks[0], ticks.data(),
            sizeof ticks[0], VK_QUERY_RESULT_64_BIT | VK_QUERY_RESULT_WAIT_BIT),
        "reading timers");
  // Clocks of less than 64 bits wrap around; a difference modulo their width does not mind.
  const Adapter& adapter = context_.adapter();
  const std::uint32_t bits = adapter.abilities.queues[adapter.queue_family].timestampValidBits;
  const std::uint64_t mask = bits < 64 ? (std::uint64_t{1} << bits) - 1 : ~std::uint64_t{0};
  const double ms_per_tick = 1e-6 * static_cast<double>(context_.limits().timestampPeriod);
  for (std::size_t i = 0; i < passes.size(); ++i)
    times.push_back({passes[i].label,
                     ms_per_tick * static_cast<double>((ticks[2 * i + 1] - ticks[2 * i]) & mask)});
}

} // namespace gg::gpu::vulkan
