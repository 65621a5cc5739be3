// A window that OpenGL draws into.
#pragma once

#include "gpu/opengl/context.h"
#include "gpu/opengl/device.h"
#include "gpu/surface/desktop_window.h"

namespace gg::gpu::opengl {

class GlWindow final : public surface::DesktopWindow {
public:
  explicit GlWindow(const WindowDesc& desc);
  ~GlWindow() override;

  Device& device() override { return *device_; }
  void begin_frame() override;
  void present(const TextureRef& picture, std::vector<std::byte>* shown) override;

private:
  ContextRef context_;
  std::unique_ptr<GlDevice> device_;
};

} // namespace gg::gpu::opengl
