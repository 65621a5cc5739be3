#include "core/error.h"
#include "gpu/backends.h"

namespace gg::gpu {
namespace {

struct Entry {
  Backend backend;
  const char* name;
  std::vector<DeviceInfo> (*list)();
  std::unique_ptr<Device> (*create)(const DeviceDesc&);
};

constexpr Entry entries[] = {
    {Backend::opengl, "opengl", opengl::list_devices, opengl::create_device},
    {Backend::vulkan, "vulkan", vulkan::list_devices, vulkan::create_device},
};

} // namespace

std::unique_ptr<Device> create_device(const DeviceDesc& desc) {
  DeviceDesc local = desc;
  for (const Entry& entry : entries) {
    if (entry.backend == desc.backend) return entry.create(local);
    // The listing goes on with the next backend's devices.
    if (desc.device < 0) continue;
    local.device -= static_cast<int>(entry.list().size());
    if (local.device < 0)
      throw Error(ExitCode::device, "--device " + std::to_string(desc.device),
                  std::string("is a device of ") + entry.name, "Choose that --backend.");
  }
  throw Error(ExitCode::unsupported, "--backend", "this program was built without it",
              "Choose --backend opengl.");
}

std::unique_ptr<Window> create_window(const WindowDesc& desc) {
  if (desc.backend != Backend::opengl)
    throw Error(ExitCode::unsupported, "--backend", "only OpenGL draws into windows so far",
                "Leave it out; capture takes both.");
  return opengl::create_window(desc);
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
