// What windows have in common whichever API draws into them: all but the drawing.
#pragma once

#include "gpu/surface/glfw_window.h"

namespace gg::gpu::surface {

class DesktopWindow : public Window {
public:
  int width() const override { return window_.width(); }
  int height() const override { return window_.height(); }
  float scale() const override { return window_.scale(); }
  bool should_close() const override { return glfwWindowShouldClose(window_.handle()); }
  void close() override { glfwSetWindowShouldClose(window_.handle(), GLFW_TRUE); }
  void set_title(const std::string& title) override {
    glfwSetWindowTitle(window_.handle(), title.c_str());
  }
  bool is_full_screen() const override { return window_.is_full_screen(); }
  void set_full_screen(bool on) override { window_.set_full_screen(on); }
  void poll_events() override { window_.poll(); }
  void wait_events(double seconds) override { window_.wait(seconds); }
  void wake() override { glfwPostEmptyEvent(); }
  std::uint64_t event_count() const override { return window_.event_count(); }
  std::vector<KeyPress> take_keys() override { return window_.take_keys(); }
  std::vector<Drag> take_drags() override { return window_.take_drags(); }
  std::vector<std::string> take_dropped() override { return window_.take_dropped(); }

protected:
  DesktopWindow(const WindowDesc& desc, bool opengl) : window_(desc, opengl) {}

  GlfwWindow window_;
};

} // namespace gg::gpu::surface
