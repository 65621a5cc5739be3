#include "core/error.h"
#include "core/library.h"
#include "gpu/surface/surface.h"

#include <GL/osmesa.h>

#include <array>
#include <cstdint>

namespace gg::gpu::surface {
namespace {

struct OsmesaFunctions {
  Library library{{"libOSMesa.so.8", "libOSMesa.so.6"}}; // the latter is a name for the same
  decltype(&OSMesaCreateContextAttribs) create = nullptr;
  decltype(&OSMesaDestroyContext) destroy = nullptr;
  decltype(&OSMesaMakeCurrent) make_current = nullptr;
  decltype(&OSMesaGetProcAddress) get_proc_address = nullptr;

  OsmesaFunctions() {
    library.load(create, "OSMesaCreateContextAttribs");
    library.load(destroy, "OSMesaDestroyContext");
    library.load(make_current, "OSMesaMakeCurrent");
    library.load(get_proc_address, "OSMesaGetProcAddress");
  }
  bool complete() const { return create && destroy && make_current && get_proc_address; }
};

const OsmesaFunctions& osmesa() {
  static const OsmesaFunctions functions;
  return functions;
}

class OsmesaContext final : public Context {
public:
  explicit OsmesaContext(OSMesaContext context) : context_(context) {}
  ~OsmesaContext() override {
    leave();
    osmesa().destroy(context_);
  }
  Proc proc(const char* name) const override { return osmesa().get_proc_address(name); }

private:
  bool bind() override {
    return osmesa().make_current(context_, buffer_.data(), GL_UNSIGNED_BYTE, width, height);
  }
  void unbind() noexcept override { osmesa().make_current(nullptr, nullptr, 0, 0, 0); }

  // OSMesa cannot do without a picture of its own to draw into; nothing is ever drawn there.
  static constexpr int width = 4, height = 4;
  std::array<std::uint8_t, 4 * width * height> buffer_{};
  OSMesaContext context_;
};

} // namespace

std::unique_ptr<Context> open_osmesa() {
  const OsmesaFunctions& api = osmesa();
  if (!api.library)
    throw Error(ExitCode::device, "OSMesa", "libOSMesa.so is not on this machine",
                "Install libosmesa6, or choose --surface egl.");
  if (!api.complete())
    throw Error(ExitCode::device, "OSMesa", "this libOSMesa.so is too old",
                "Install Mesa 22 or newer, or choose --surface egl.");
  constexpr std::array attributes = {OSMESA_FORMAT,
                                     OSMESA_RGBA,
                                     OSMESA_PROFILE,
                                     OSMESA_CORE_PROFILE,
                                     OSMESA_CONTEXT_MAJOR_VERSION,
                                     4,
                                     OSMESA_CONTEXT_MINOR_VERSION,
                                     5,
                                     0,
                                     0};
  OSMesaContext context = api.create(attributes.data(), nullptr);
  if (!context)
    throw Error(ExitCode::device, "OSMesa", "does not offer OpenGL 4.5 core",
                "Install Mesa 22 or newer with llvmpipe, or choose --surface egl.");
  return std::make_unique<OsmesaContext>(context);
}

} // namespace gg::gpu::surface
