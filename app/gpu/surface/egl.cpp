#include "core/error.h"
#include "core/library.h"
#include "gpu/surface/surface.h"

#define EGL_NO_X11
#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <algorithm>
#include <array>
#include <mutex>
#include <set>
#include <string_view>

namespace gg::gpu::surface {
namespace {

constexpr const char* remedy = "Install libegl1 and libegl-mesa0 (or the GPU's own driver), or "
                               "choose --surface osmesa.";

struct EglFunctions {
  Library library{{"libEGL.so.1"}};
  PFNEGLGETPROCADDRESSPROC get_proc_address = nullptr;
  PFNEGLQUERYSTRINGPROC query_string = nullptr;
  PFNEGLINITIALIZEPROC initialize = nullptr;
  PFNEGLBINDAPIPROC bind_api = nullptr;
  PFNEGLCREATECONTEXTPROC create_context = nullptr;
  PFNEGLDESTROYCONTEXTPROC destroy_context = nullptr;
  PFNEGLMAKECURRENTPROC make_current = nullptr;
  PFNEGLGETERRORPROC get_error = nullptr;
  PFNEGLGETPLATFORMDISPLAYEXTPROC get_platform_display = nullptr;
  PFNEGLQUERYDEVICESEXTPROC query_devices = nullptr;
  PFNEGLQUERYDEVICESTRINGEXTPROC query_device_string = nullptr;

  EglFunctions() {
    library.load(get_proc_address, "eglGetProcAddress");
    library.load(query_string, "eglQueryString");
    library.load(initialize, "eglInitialize");
    library.load(bind_api, "eglBindAPI");
    library.load(create_context, "eglCreateContext");
    library.load(destroy_context, "eglDestroyContext");
    library.load(make_current, "eglMakeCurrent");
    library.load(get_error, "eglGetError");
    if (!get_proc_address) return;
    extension(get_platform_display, "eglGetPlatformDisplayEXT");
    extension(query_devices, "eglQueryDevicesEXT");
    extension(query_device_string, "eglQueryDeviceStringEXT");
  }
  template <class Function>
  void extension(Function& function, const char* name) {
    function = reinterpret_cast<Function>(get_proc_address(name));
  }
  bool complete() const {
    return get_proc_address && query_string && initialize && bind_api && create_context
           && destroy_context && make_current && get_error && get_platform_display;
  }
};

const EglFunctions& egl() {
  static const EglFunctions functions;
  return functions;
}

// Whether a list of words separated by spaces has this one.
bool lists(const char* words, std::string_view word) {
  std::string_view rest = words ? words : "";
  while (!rest.empty()) {
    const std::size_t end = std::min(rest.find(' '), rest.size());
    if (rest.substr(0, end) == word) return true;
    rest.remove_prefix(std::min(end + 1, rest.size()));
  }
  return false;
}

bool client_has(std::string_view extension) {
  return lists(egl().query_string(EGL_NO_DISPLAY, EGL_EXTENSIONS), extension);
}

std::vector<EGLDeviceEXT> devices() {
  if (!egl().complete() || !egl().query_devices || !client_has("EGL_EXT_platform_device"))
    return {};
  EGLint count = 0;
  if (!egl().query_devices(0, nullptr, &count)) return {};
  std::vector<EGLDeviceEXT> result(static_cast<std::size_t>(count));
  if (!egl().query_devices(count, result.data(), &count)) return {};
  result.resize(static_cast<std::size_t>(count));
  return result;
}

// EGL hands out one display per device, and terminating it ends every context on it and unloads the
// driver. So it is opened for the first context and stays open.
EGLDisplay opened(EGLDisplay display) {
  static std::mutex mutex;
  static std::set<EGLDisplay> open;
  const std::lock_guard lock(mutex);
  if (open.contains(display)) return display;
  if (!display || !egl().initialize(display, nullptr, nullptr))
    throw Error(ExitCode::device, "EGL", "a display cannot be opened", remedy);
  open.insert(display);
  return display;
}

class EglContext final : public Context {
public:
  EglContext(EGLDisplay display, EGLContext context) : display_(display), context_(context) {}
  ~EglContext() override {
    leave();
    egl().destroy_context(display_, context_);
  }
  Proc proc(const char* name) const override { return egl().get_proc_address(name); }

private:
  bool bind() override {
    return egl().bind_api(EGL_OPENGL_API)
           && egl().make_current(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_);
  }
  void unbind() noexcept override {
    egl().bind_api(EGL_OPENGL_API);
    egl().make_current(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  }

  EGLDisplay display_;
  EGLContext context_;
};

EGLDisplay find_display(const EglChoice& choice) {
  if (choice.device < 0)
    return egl().get_platform_display(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
  const std::vector<EGLDeviceEXT> all = devices();
  if (static_cast<std::size_t>(choice.device) >= all.size())
    throw Error(ExitCode::device, "EGL",
                "has no device " + std::to_string(choice.device) + " any more");
  return egl().get_platform_display(EGL_PLATFORM_DEVICE_EXT,
                                    all[static_cast<std::size_t>(choice.device)], nullptr);
}

} // namespace

std::vector<EglChoice> egl_choices() {
  std::vector<EglChoice> result;
  if (!egl().complete()) return result;
  const std::vector<EGLDeviceEXT> all = devices();
  bool software = false;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const char* extensions =
        egl().query_device_string ? egl().query_device_string(all[i], EGL_EXTENSIONS) : nullptr;
    result.push_back({static_cast<int>(i), lists(extensions, "EGL_MESA_device_software")});
    software |= result.back().software;
  }
  // Mesa's rasterizer where EGL does not list it as a device.
  if (!software && client_has("EGL_MESA_platform_surfaceless")) result.push_back({-1, true});
  return result;
}

std::unique_ptr<Context> open_egl(const EglChoice& choice, bool debug) {
  const EglFunctions& api = egl();
  if (!api.library)
    throw Error(ExitCode::device, "EGL", "libEGL.so.1 is not on this machine", remedy);
  if (!api.complete())
    throw Error(ExitCode::device, "EGL", "this libEGL.so.1 is older than EGL 1.5", remedy);
  const EGLDisplay where = opened(find_display(choice));
  const char* extensions = api.query_string(where, EGL_EXTENSIONS);
  for (const char* needed : {"EGL_KHR_surfaceless_context", "EGL_KHR_no_config_context"})
    if (!lists(extensions, needed))
      throw Error(ExitCode::device, "EGL", std::string("its driver lacks ") + needed, remedy);

  const std::array<EGLint, 9> attributes = {EGL_CONTEXT_MAJOR_VERSION,
                                            4,
                                            EGL_CONTEXT_MINOR_VERSION,
                                            5,
                                            EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                            EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                            EGL_CONTEXT_OPENGL_DEBUG,
                                            debug ? EGL_TRUE : EGL_FALSE,
                                            EGL_NONE};
  EGLContext context = EGL_NO_CONTEXT;
  if (api.bind_api(EGL_OPENGL_API))
    context = api.create_context(where, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, attributes.data());
  if (!context)
    throw Error(ExitCode::device, "EGL", "its driver does not offer OpenGL 4.5 core",
                "Update the driver, choose another --device, or choose --surface osmesa.");
  return std::make_unique<EglContext>(where, context);
}

} // namespace gg::gpu::surface
