// What each backend offers to create.cpp. A `device` here is an index in that backend's own list.
#pragma once

#include "gpu/device.h"
#include "gpu/window.h"

namespace gg::gpu::opengl {
std::vector<DeviceInfo> list_devices();
std::unique_ptr<Device> create_device(const DeviceDesc& desc);
std::unique_ptr<Window> create_window(const WindowDesc& desc);
} // namespace gg::gpu::opengl

namespace gg::gpu::vulkan {
std::vector<DeviceInfo> list_devices();
std::unique_ptr<Device> create_device(const DeviceDesc& desc);
std::unique_ptr<Window> create_window(const WindowDesc& desc);
} // namespace gg::gpu::vulkan
