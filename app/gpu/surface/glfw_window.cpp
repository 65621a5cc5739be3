#include "gpu/surface/glfw_window.h"

#include "core/error.h"
#include "core/files.h"
#include "gpu/surface/lost_display.h"

#include <backends/imgui_impl_glfw.h>
#include <imgui.h>

#include <cmath>
#include <utility>

namespace gg::gpu::surface {
namespace {

std::string last_error() {
  const char* text = nullptr;
  glfwGetError(&text);
  return text ? text : "no reason is given";
}

// GLFW is one for the process: from the first window to the last.
int windows = 0;

void start() {
  if (windows > 0) return;
  if (!glfwInit())
    throw Error(ExitCode::device, "window",
                "there is no display to open it on (" + last_error() + ")",
                "Log in to a desktop or set DISPLAY; groundglass capture draws without a window.");
  exit_when_the_display_is_lost();
}

class WindowContext final : public Context {
public:
  explicit WindowContext(GLFWwindow* window) : window_(window) {}
  ~WindowContext() override { leave(); }
  Proc proc(const char* name) const override { return glfwGetProcAddress(name); }

private:
  bool bind() override {
    glfwMakeContextCurrent(window_);
    return glfwGetCurrentContext() == window_;
  }
  void unbind() noexcept override { glfwMakeContextCurrent(nullptr); }

  GLFWwindow* window_;
};

GlfwWindow& self(GLFWwindow* window) {
  return *static_cast<GlfwWindow*>(glfwGetWindowUserPointer(window));
}

} // namespace

GlfwWindow::GlfwWindow(const WindowDesc& desc, bool opengl) {
  start();
  glfwDefaultWindowHints();
  glfwWindowHint(GLFW_SCALE_TO_MONITOR, desc.scale == 0.0f ? GLFW_TRUE : GLFW_FALSE);
  glfwWindowHint(GLFW_DEPTH_BITS, 0);
  glfwWindowHint(GLFW_STENCIL_BITS, 0);
  glfwWindowHint(GLFW_CLIENT_API, opengl ? GLFW_OPENGL_API : GLFW_NO_API);
  if (opengl) {
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 4);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 5);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    glfwWindowHint(GLFW_OPENGL_DEBUG_CONTEXT, desc.debug ? GLFW_TRUE : GLFW_FALSE);
  }
  window_ = glfwCreateWindow(desc.width, desc.height, desc.title.c_str(), nullptr, nullptr);
  if (!window_ && opengl) { // a display without GLX may have EGL
    glfwWindowHint(GLFW_CONTEXT_CREATION_API, GLFW_EGL_CONTEXT_API);
    window_ = glfwCreateWindow(desc.width, desc.height, desc.title.c_str(), nullptr, nullptr);
  }
  if (!window_) {
    const std::string reason = last_error();
    if (windows == 0) glfwTerminate();
    throw Error(ExitCode::device, "window", "it cannot be opened (" + reason + ")",
                "Install a driver for OpenGL 4.5 (Debian: libgl1, libglx-mesa0 and "
                "libgl1-mesa-dri), or try --backend "
                "vulkan; groundglass capture draws without a window.");
  }
  ++windows;
  glfwSetWindowUserPointer(window_, this);
  float across = 1.0f, down = 1.0f;
  glfwGetWindowContentScale(window_, &across, &down);
  scale_ = desc.scale > 0.0f ? desc.scale : std::max(across, 1.0f);
  glfwSetWindowSizeLimits(window_, 320, 240, GLFW_DONT_CARE, GLFW_DONT_CARE);
  read_size();
  listen();
}

GlfwWindow::~GlfwWindow() {
  if (panels_) {
    ImGui_ImplGlfw_Shutdown();
    ImGui::DestroyContext();
  }
  glfwDestroyWindow(window_);
  if (--windows == 0) glfwTerminate();
}

std::unique_ptr<Context> GlfwWindow::context() const {
  return std::make_unique<WindowContext>(window_);
}

void GlfwWindow::listen() {
  // Dear ImGui's callbacks, set later, call these.
  glfwSetKeyCallback(window_, [](GLFWwindow* w, int pressed, int, int action, int modifiers) {
    ++self(w).events_;
    if (action == GLFW_RELEASE) return;
    self(w).keys_.push_back({pressed, (modifiers & GLFW_MOD_CONTROL) != 0,
                             (modifiers & GLFW_MOD_SHIFT) != 0, action == GLFW_REPEAT});
  });
  glfwSetCharCallback(window_, [](GLFWwindow* w, unsigned) { ++self(w).events_; });
  glfwSetMouseButtonCallback(window_, [](GLFWwindow* w, int button, int action, int) {
    ++self(w).events_;
    if (button >= 0 && button < 3) self(w).take_button(button, action == GLFW_PRESS);
  });
  glfwSetScrollCallback(window_, [](GLFWwindow* w, double, double) { ++self(w).events_; });
  glfwSetCursorPosCallback(window_, [](GLFWwindow* w, double x, double y) {
    ++self(w).events_;
    self(w).take_cursor(static_cast<float>(x), static_cast<float>(y));
  });
  glfwSetWindowFocusCallback(window_, [](GLFWwindow* w, int) { ++self(w).events_; });
  glfwSetWindowRefreshCallback(window_, [](GLFWwindow* w) { ++self(w).events_; });
  glfwSetWindowCloseCallback(window_, [](GLFWwindow* w) { ++self(w).events_; });
  glfwSetFramebufferSizeCallback(window_, [](GLFWwindow* w, int, int) {
    ++self(w).events_;
    self(w).read_size();
  });
  glfwSetWindowContentScaleCallback(window_, [](GLFWwindow* w, float across, float) {
    ++self(w).events_;
    self(w).scale_ = std::max(across, 1.0f);
  });
  glfwSetDropCallback(window_, [](GLFWwindow* w, int count, const char** paths) {
    ++self(w).events_;
    self(w).dropped_.insert(self(w).dropped_.end(), paths, paths + count);
  });
}

void GlfwWindow::read_size() {
  glfwGetFramebufferSize(window_, &width_, &height_);
}

void GlfwWindow::set_full_screen(bool on) {
  if (on == is_full_screen()) return;
  if (!on) {
    glfwSetWindowMonitor(window_, nullptr, windowed_[0], windowed_[1], windowed_[2], windowed_[3],
                         GLFW_DONT_CARE);
    return;
  }
  GLFWmonitor* monitor = glfwGetPrimaryMonitor();
  const GLFWvidmode* mode = monitor ? glfwGetVideoMode(monitor) : nullptr;
  if (!mode) return;
  glfwGetWindowPos(window_, &windowed_[0], &windowed_[1]);
  glfwGetWindowSize(window_, &windowed_[2], &windowed_[3]);
  glfwSetWindowMonitor(window_, monitor, 0, 0, mode->width, mode->height, mode->refreshRate);
}

void GlfwWindow::poll() {
  glfwPollEvents();
}

void GlfwWindow::wait(double seconds) {
  if (std::isfinite(seconds))
    glfwWaitEventsTimeout(seconds);
  else
    glfwWaitEvents();
}

std::vector<KeyPress> GlfwWindow::take_keys() {
  return std::exchange(keys_, {});
}

Drag GlfwWindow::drag_of(int button) const {
  const auto held = [this](int left, int right) {
    return glfwGetKey(window_, left) == GLFW_PRESS || glfwGetKey(window_, right) == GLFW_PRESS;
  };
  const Button& from = buttons_[static_cast<std::size_t>(button)];
  return {.button = button,
          .control = held(GLFW_KEY_LEFT_CONTROL, GLFW_KEY_RIGHT_CONTROL),
          .shift = held(GLFW_KEY_LEFT_SHIFT, GLFW_KEY_RIGHT_SHIFT),
          .from_x = from.x,
          .from_y = from.y,
          .x = x_,
          .y = y_};
}

void GlfwWindow::take_button(int button, bool down) {
  Button& held = buttons_[static_cast<std::size_t>(button)];
  if (!down && held.down && !held.moved) {
    drags_.push_back(drag_of(button));
    drags_.back().click = true;
  }
  held = {down, false, x_, y_};
}

void GlfwWindow::take_cursor(float x, float y) {
  constexpr float hand_is_still = 4.0f; // a click may move the mouse by so much
  const float moved_x = x - x_, moved_y = y - y_;
  x_ = x, y_ = y;
  for (int button = 0; button < 3; ++button) {
    Button& held = buttons_[static_cast<std::size_t>(button)];
    if (!held.down) continue;
    Drag drag = drag_of(button);
    if (held.moved) {
      drag.moved_x = moved_x, drag.moved_y = moved_y;
    } else {
      drag.moved_x = x - held.x, drag.moved_y = y - held.y;
      held.moved = std::hypot(drag.moved_x, drag.moved_y) > hand_is_still;
    }
    if (held.moved) drags_.push_back(drag);
  }
}

std::vector<Drag> GlfwWindow::take_drags() {
  return std::exchange(drags_, {});
}

std::vector<std::string> GlfwWindow::take_dropped() {
  return std::exchange(dropped_, {});
}

void GlfwWindow::start_panels() {
  IMGUI_CHECKVERSION();
  ImGui::CreateContext();
  panels_ = true;
  ImGui::GetIO().IniFilename = nullptr;       // the panels' places follow from the window's size
  ImGui_ImplGlfw_InitForOther(window_, true); // it asks no API anything
}

void GlfwWindow::begin_panels() {
  ImGui_ImplGlfw_NewFrame();
  ImGui::NewFrame();
}

} // namespace gg::gpu::surface
