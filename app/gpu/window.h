// A window with a device that draws into it, and Dear ImGui's panels over what is drawn. One thread, the one that made it, calls
// all of it but wake(). The keyboard and the mouse are read from ImGui::GetIO(), presses of keys from take_keys(): upper-case
// ASCII, or a number of gpu::key.
#pragma once

#include "gpu/device.h"

#include <memory>
#include <string>
#include <vector>

namespace gg::gpu {

struct WindowDesc {
  std::string title;
  int width = 1280, height = 720; // pixels
  Backend backend = Backend::opengl;
  int device = -1;    // of Vulkan, as DeviceDesc; OpenGL draws where the display does
  bool debug = false; // as DeviceDesc
  bool wait_for_display =
      true;           // pictures are shown at the display's rate; false: as fast as they come
  float scale = 0.0f; // of the panels; 0: the display's own
};

// Keys that are no characters.
namespace key {
constexpr int right = 262, left = 263, down = 264, up = 265, home = 268;
constexpr int escape = 256, enter = 257, tab = 258, f1 = 290, f11 = 300, keypad_0 = 320,
              keypad_period = 330, keypad_enter = 335;
} // namespace key

// A key that went down, or was held until it was repeated.
struct KeyPress {
  int key = 0;
  bool control = false, shift = false, repeated = false;
};

// A movement of the mouse with a button held, in Dear ImGui's coordinates; a press and a release at one place has `click`.
struct Drag {
  int button = 0; // 0 left, 1 right, 2 middle
  bool control = false, shift = false, click = false;
  float from_x = 0.0f, from_y = 0.0f; // where the button went down
  float x = 0.0f, y = 0.0f;           // where it is now
  float moved_x = 0.0f, moved_y = 0.0f;
};

class Window {
public:
  virtual ~Window() = default;

  virtual Device& device() = 0;

  virtual int width() const = 0; // of what is drawn, pixels; 0 while minimised
  virtual int height() const = 0;
  virtual float scale() const = 0; // how much larger than usual text is to be
  virtual bool should_close() const = 0;
  virtual void close() = 0;
  virtual void set_title(const std::string& title) = 0;
  virtual bool is_full_screen() const = 0;
  virtual void set_full_screen(bool on) = 0;

  // Takes what the user did, without waiting or until there is something: an event, a wake(), or the time is over.
  virtual void poll_events() = 0;
  virtual void wait_events(double seconds) = 0;
  virtual void wake() = 0; // from any thread
  // Of events taken so far; two pictures after the last, panels have settled.
  virtual std::uint64_t event_count() const = 0;
  virtual std::vector<KeyPress>
  take_keys() = 0; // since the last call: none is lost in a long frame
  virtual std::vector<Drag> take_drags() = 0;
  virtual std::vector<std::string>
  take_dropped() = 0; // paths dropped on the window since the last call

  // Starts Dear ImGui's frame; its coordinates are pixels.
  virtual void begin_frame() = 0;
  // Ends it and shows `picture` (rgba8 with Use::attachment and Use::read_back, as large as the window; the panels may be drawn
  // into it) with the panels over it. With `shown`, also reads what is shown: RGBA, width() x height(), row 0 first.
  virtual void present(const TextureRef& picture, std::vector<std::byte>* shown = nullptr) = 0;
};

// Throws Error(device): no display, or no driver that draws into one, and what to do.
std::unique_ptr<Window> create_window(const WindowDesc& desc);

} // namespace gg::gpu
