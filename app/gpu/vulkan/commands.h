// Command buffers in a ring: one is recorded while the device works on those before it. Each slot
// of the ring owns what its submission needs until the device is done with it: the command buffer
// and staging memory.
#pragma once

#include "gpu/vulkan/context.h"

#include <array>
#include <memory>
#include <vector>

namespace gg::gpu::vulkan {

// Host-visible bytes to copy from.
struct Staged {
  VkBuffer buffer = VK_NULL_HANDLE;
  VkDeviceSize offset = 0;
  std::byte* mapped = nullptr;
};

// A buffer that the host sees.
struct HostBuffer {
  HostBuffer(Context& owner, VkDeviceSize size, MemoryKind kind, const std::string& label);
  ~HostBuffer(); // the device no longer uses it
  HostBuffer(const HostBuffer&) = delete;
  HostBuffer& operator=(const HostBuffer&) = delete;

  Context& context;
  VkBuffer handle = VK_NULL_HANDLE;
  Allocation memory;
  VkDeviceSize bytes = 0;
};

// What a submission waits for before it copies, and what it signals at its end; null: nothing.
struct Around {
  VkSemaphore wait = VK_NULL_HANDLE, signal = VK_NULL_HANDLE;
};

class Commands {
public:
  explicit Commands(Context& context);
  ~Commands();
  Commands(const Commands&) = delete;
  Commands& operator=(const Commands&) = delete;

  // The command buffer that is being recorded, begun if none is. Beginning waits for the device if
  // it is a whole ring behind.
  VkCommandBuffer open();
  // Room in the open command buffer's slot.
  Staged stage(VkDeviceSize bytes);

  void submit(const Around& around = {}); // what has been recorded, if anything
  void finish();                          // submit, and wait for all of it
  bool is_full() const;                   // much is staged: better submit before staging more

  double waited_ms = 0.0; // for the device, in open()

private:
  // Two keep the device busy while the host records; a third evens out frames of unequal length.
  static constexpr std::size_t slot_count = 3;
  struct Slot {
    explicit Slot(Context& owner) : context(owner) {}
    ~Slot();
    Slot(const Slot&) = delete;
    Slot& operator=(const Slot&) = delete;

    Context& context;
    VkCommandPool pool = VK_NULL_HANDLE;
    VkCommandBuffer commands = VK_NULL_HANDLE;
    std::uint64_t value = 0; // the timeline's when the device is done with it
    std::vector<std::unique_ptr<HostBuffer>> pages;
    std::size_t page = 0;  // that is being filled
    VkDeviceSize used = 0; // of it
    VkDeviceSize staged = 0;
  };
  Slot& slot() { return *slots_[current_]; }

  Context& context_;
  std::array<std::unique_ptr<Slot>, slot_count> slots_;
  std::size_t current_ = 0;
};

} // namespace gg::gpu::vulkan
