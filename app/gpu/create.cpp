#include "core/error.h"
#include "gpu/backends.h"

namespace gg::gpu {
namespace {

struct Entry {
  Backend backend;
  const char* name;
  std::vector<DeviceInfo> (*list)();
  std::unique_ptr<Device> (*create)(const DeviceDesc&);
  std::unique_ptr<Window> (*create_window)(const WindowDesc&);
};

constexpr Entry entries[] = {
    {Backend::opengl, "opengl", opengl::list_devices, opengl::create_device, opengl::create_window},
    {Backend::vulkan, "vulkan", vulkan::list_devices, vulkan::create_device, vulkan::create_window},
};

// The backend, and `device`, which counts those of all backends, as an index in its own list.
const Entry& find(Backend backend, int& device) {
  const int wanted = device;
  for (const Entry& entry : entries) {
    if (entry.backend == backend) return entry;
    // The listing goes on with the next backend's devices.
    if (wanted < 0) continue;
    device -= static_cast<int>(entry.list().size());
    if (device < 0)
      throw Error(ExitCode::device, "--device " + std::to_string(wanted),
                  std::string("is a device of ") + entry.name, "Choose that --backend.");
  }
  throw Error(ExitCode::unsupported, "--backend", "this program was built without it",
              "Choose --backend opengl.");
}

} // namespace

std::unique_ptr<Device> create_device(const DeviceDesc& desc) {
  DeviceDesc local = desc;
  return find(desc.backend, local.device).create(local);
}

std::unique_ptr<Window> create_window(const WindowDesc& desc) {
  WindowDesc local = desc;
  return find(desc.backend, local.device).create_window(local);
}

std::vector<DeviceInfo> list_devices() {
  std::vector<DeviceInfo> all;
  for (const Entry& entry : entries)
    for (DeviceInfo& info : entry.list()) {
      info.index = static_cast<int>(all.size());
      all.push_back(std::move(info));
    }
  return all;
}

} // namespace gg::gpu
