// A window of the desktop (X11, Wayland) by GLFW, with what the user does in it.
#pragma once

#include "gpu/surface/surface.h"
#include "gpu/window.h"

#define VK_NO_PROTOTYPES
#include <vulkan/vulkan_core.h> // which GLFW's header looks for
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <array>
#include <memory>
#include <string>
#include <vector>

namespace gg::gpu::surface {

class GlfwWindow {
public:
  // With OpenGL 4.5 core, or without any API of its own. Throws Error(device).
  GlfwWindow(const WindowDesc& desc, bool opengl);
  ~GlfwWindow();
  GlfwWindow(const GlfwWindow&) = delete;
  GlfwWindow& operator=(const GlfwWindow&) = delete;

  GLFWwindow* handle() const { return window_; }
  std::unique_ptr<Context> context() const; // of a window with OpenGL, which must outlive it

  int width() const { return width_; }
  int height() const { return height_; }
  float scale() const { return scale_; }
  bool is_full_screen() const { return glfwGetWindowMonitor(window_) != nullptr; }
  void set_full_screen(bool on);
  std::uint64_t event_count() const { return events_; }
  void poll();
  void wait(double seconds);
  std::vector<KeyPress> take_keys();
  std::vector<Drag> take_drags();
  std::vector<std::string> take_dropped();

  // Dear ImGui's context and its GLFW backend; the drawing is the caller's.
  void start_panels();
  void begin_panels();

private:
  void listen();
  void read_size();
  Drag drag_of(int button) const;
  void take_button(int button, bool down);
  void take_cursor(float x, float y);

  GLFWwindow* window_ = nullptr;
  int width_ = 0, height_ = 0;
  float scale_ = 1.0f;
  int windowed_[4] = {0, 0, 1280, 720}; // where it was before it filled the screen
  std::uint64_t events_ = 0;
  std::vector<KeyPress> keys_;
  std::vector<Drag> drags_;
  struct Button {
    bool down = false, moved = false;
    float x = 0.0f, y = 0.0f; // where it went down
  };
  std::array<Button, 3> buttons_;
  float x_ = 0.0f, y_ = 0.0f; // of the cursor, as of the last event
  std::vector<std::string> dropped_;
  bool panels_ = false;
};

} // namespace gg::gpu::surface
