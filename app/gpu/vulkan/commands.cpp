#include "gpu/vulkan/commands.h"

#include "core/clock.h"

#include <fmt/format.h>

#include <algorithm>

namespace gg::gpu::vulkan {

namespace {

constexpr VkDeviceSize page_bytes = VkDeviceSize{1} << 20;
// What a slot keeps for its next turn: more than any frame stages; loading a scene takes more.
constexpr VkDeviceSize kept_bytes = VkDeviceSize{8} << 20;
// What one submission stages at most before it is sent off: bounds the host memory that loading a
// scene takes to a few times this.
constexpr VkDeviceSize staged_at_once = VkDeviceSize{64} << 20;
// Copies into images must start at a multiple of the texel's size, at most 16 bytes, and of 4.
constexpr VkDeviceSize staging_alignment = 16;

} // namespace

HostBuffer::HostBuffer(Context& owner, VkDeviceSize size, MemoryKind kind, const std::string& label)
    : context(owner), bytes(size) {
  const VkBufferCreateInfo info{.sType = VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO,
                                .size = bytes,
                                .usage = VK_BUFFER_USAGE_TRANSFER_SRC_BIT
                                         | VK_BUFFER_USAGE_TRANSFER_DST_BIT,
                                .sharingMode = VK_SHARING_MODE_EXCLUSIVE};
  const std::string doing = "creating the buffer '" + label + "' (" + in_words(bytes) + ")";
  if (const auto result = context.vk().CreateBuffer(context.device(), &info, nullptr, &handle))
    throw error_of(result, doing);
  try {
    memory = context.bind_memory(handle, kind, doing);
    context.name(VK_OBJECT_TYPE_BUFFER, handle, label);
  } catch (...) {
    context.vk().DestroyBuffer(context.device(), handle, nullptr);
    throw;
  }
  ++context.counters.created;
}

HostBuffer::~HostBuffer() {
  context.vk().DestroyBuffer(context.device(), handle, nullptr);
  context.memory().give(memory);
}

Commands::Slot::~Slot() {
  if (pool) context.vk().DestroyCommandPool(context.device(), pool, nullptr);
}

Commands::Commands(Context& context) : context_(context) {
  const DeviceFunctions& vk = context.vk();
  for (std::size_t i = 0; i < slots_.size(); ++i) {
    slots_[i] = std::make_unique<Slot>(context);
    Slot& made = *slots_[i];
    const VkCommandPoolCreateInfo pool{.sType = VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO,
                                       .flags = VK_COMMAND_POOL_CREATE_TRANSIENT_BIT,
                                       .queueFamilyIndex = context.adapter().queue_family};
    check(vk.CreateCommandPool(context.device(), &pool, nullptr, &made.pool),
          "creating a command pool");
    context.name(VK_OBJECT_TYPE_COMMAND_POOL, made.pool, fmt::format("commands {}", i));
    const VkCommandBufferAllocateInfo buffer{.sType =
                                                 VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO,
                                             .commandPool = made.pool,
                                             .level = VK_COMMAND_BUFFER_LEVEL_PRIMARY,
                                             .commandBufferCount = 1};
    check(vk.AllocateCommandBuffers(context.device(), &buffer, &made.commands),
          "allocating a command buffer");
    context.name(VK_OBJECT_TYPE_COMMAND_BUFFER, made.commands, fmt::format("commands {}", i));
    // Made now, so that no later frame makes it because its turn comes to use this slot.
    made.pages.push_back(
        std::make_unique<HostBuffer>(context, page_bytes, MemoryKind::upload, "staging"));
  }
}

Commands::~Commands() {
  context_.vk().DeviceWaitIdle(context_.device());
  context_.recording = false;
}

VkCommandBuffer Commands::open() {
  if (context_.recording) return slot().commands;

  current_ = (current_ + 1) % slots_.size();
  Slot& next = slot();
  if (context_.completed() < next.value) {
    const auto start = Clock::now();
    context_.wait(next.value);
    waited_ms += ms_since(start);
  }
  context_.collect();
  VkDeviceSize kept = 0;
  std::erase_if(next.pages, [&](const auto& page) { return (kept += page->bytes) > kept_bytes; });
  next.page = 0, next.used = 0, next.staged = 0;

  check(context_.vk().ResetCommandPool(context_.device(), next.pool, 0), "reusing a command pool");
  const VkCommandBufferBeginInfo begin{.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO,
                                       .flags = VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT};
  check(context_.vk().BeginCommandBuffer(next.commands, &begin), "beginning to record");
  context_.recording = true;
  return next.commands;
}

Staged Commands::stage(VkDeviceSize bytes) {
  open();
  Slot& to = slot();
  to.used = (to.used + staging_alignment - 1) & ~(staging_alignment - 1);
  while (to.page < to.pages.size() && to.used + bytes > to.pages[to.page]->bytes)
    ++to.page, to.used = 0;
  if (to.page == to.pages.size())
    to.pages.push_back(std::make_unique<HostBuffer>(context_, std::max(bytes, page_bytes),
                                                    MemoryKind::upload, "staging"));
  HostBuffer& page = *to.pages[to.page];
  const Staged staged{page.handle, to.used, page.memory.mapped + to.used};
  to.used += bytes;
  to.staged += bytes;
  return staged;
}

bool Commands::is_full() const {
  return context_.recording && slots_[current_]->staged >= staged_at_once;
}

void Commands::submit(const Around& around) {
  if (!context_.recording) return;
  Slot& sent = slot();
  const DeviceFunctions& vk = context_.vk();
  context_.recording = false; // whatever happens: what cannot be submitted is not kept
  check(vk.EndCommandBuffer(sent.commands), "recording");
  const std::uint64_t value = context_.submitted + 1;
  const VkCommandBufferSubmitInfo buffer{.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_SUBMIT_INFO,
                                         .commandBuffer = sent.commands};
  const std::array signals{
      VkSemaphoreSubmitInfo{.sType = VK_STRUCTURE_TYPE_SEMAPHORE_SUBMIT_INFO,
                            .semaphore = context_.timeline(),
                            .value = value,
                            .stageMask = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT},
      VkSemaphoreSubmitInfo{.sType = VK_STRUCTURE_TYPE_SEMAPHORE_SUBMIT_INFO,
                            .semaphore = around.signal,
                            .stageMask = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT}};
  const VkSemaphoreSubmitInfo wait{.sType = VK_STRUCTURE_TYPE_SEMAPHORE_SUBMIT_INFO,
                                   .semaphore = around.wait,
                                   .stageMask = VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT};
  const VkSubmitInfo2 info{.sType = VK_STRUCTURE_TYPE_SUBMIT_INFO_2,
                           .waitSemaphoreInfoCount = around.wait ? 1u : 0u,
                           .pWaitSemaphoreInfos = &wait,
                           .commandBufferInfoCount = 1,
                           .pCommandBufferInfos = &buffer,
                           .signalSemaphoreInfoCount = around.signal ? 2u : 1u,
                           .pSignalSemaphoreInfos = signals.data()};
  check(vk.QueueSubmit2(context_.queue(), 1, &info, VK_NULL_HANDLE), "submitting");
  context_.submitted = value;
  sent.value = value;
  ++context_.counters.submissions;
}

void Commands::finish() {
  submit();
  context_.wait(context_.submitted);
  context_.collect();
}

} // namespace gg::gpu::vulkan
