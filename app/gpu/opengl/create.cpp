// Which OpenGL devices there are, and the choice among them.
#include "core/error.h"
#include "gpu/backends.h"
#include "gpu/opengl/device.h"
#include "gpu/surface/surface.h"

#include <algorithm>
#include <optional>
#include <utility>

namespace gg::gpu::opengl {
namespace {

struct Choice {
  Surface surface = Surface::egl;
  surface::EglChoice egl;
};

std::vector<Choice> choices() {
  std::vector<Choice> result;
  for (const surface::EglChoice& egl : surface::egl_choices())
    result.push_back({Surface::egl, egl});
  result.push_back({Surface::osmesa, {}});
  return result;
}

ContextRef open(const Choice& choice, bool debug) {
  return std::make_shared<Context>(choice.surface == Surface::egl
                                       ? surface::open_egl(choice.egl, debug)
                                       : surface::open_osmesa(),
                                   debug);
}

DeviceInfo describe(const Choice& choice, const Context& context) {
  return {.index = -1,
          .backend = "opengl",
          .surface = choice.surface == Surface::egl ? "egl" : "osmesa",
          .name = context.renderer(),
          .driver = context.version(),
          .software = is_software(context.renderer())};
}

// The choices that work, with what they say of themselves.
std::vector<std::pair<Choice, DeviceInfo>> probe() {
  std::vector<std::pair<Choice, DeviceInfo>> result;
  for (const Choice& choice : choices()) {
    try {
      const ContextRef context = open(choice, false);
      result.emplace_back(choice, describe(choice, *context));
      result.back().second.index = static_cast<int>(result.size()) - 1;
    } catch (const Error&) {
      // Not usable: not listed.
    }
  }
  return result;
}

std::unique_ptr<Device> make(const Choice& choice, bool debug, int index) {
  ContextRef context = open(choice, debug);
  DeviceInfo info = describe(choice, *context);
  info.index = index;
  return std::make_unique<GlDevice>(std::move(context), std::move(info));
}

std::unique_ptr<Device> create_listed(const DeviceDesc& desc) {
  const auto all = probe();
  const std::string where = "--device " + std::to_string(desc.device);
  if (static_cast<std::size_t>(desc.device) >= all.size())
    throw Error(ExitCode::device, where, "OpenGL has no such device on this machine",
                "Choose one that is listed.");
  const auto& [choice, info] = all[static_cast<std::size_t>(desc.device)];
  if (desc.surface != Surface::automatic && desc.surface != choice.surface)
    throw Error(ExitCode::device, where, "is a device of the surface " + info.surface,
                "Choose that --surface, or leave it out.");
  return make(choice, desc.debug, desc.device);
}

} // namespace

std::vector<DeviceInfo> list_devices() {
  std::vector<DeviceInfo> result;
  for (auto& [choice, info] : probe())
    result.push_back(info);
  return result;
}

std::unique_ptr<Device> create_device(const DeviceDesc& desc) {
  if (desc.device >= 0) return create_listed(desc);
  std::vector<Choice> all = choices();
  if (desc.surface != Surface::automatic)
    std::erase_if(all, [&](const Choice& c) { return c.surface != desc.surface; });
  // Hardware first. Without any EGL there is still one attempt, for what it says is missing.
  std::ranges::stable_partition(
      all, [](const Choice& c) { return c.surface == Surface::egl && !c.egl.software; });
  const bool asked_for_egl = desc.surface != Surface::osmesa;
  if (asked_for_egl
      && std::ranges::none_of(all, [](const Choice& c) { return c.surface == Surface::egl; }))
    all.insert(all.begin(), Choice{});
  std::string reasons;
  for (const Choice& choice : all) {
    try {
      return make(choice, desc.debug, -1);
    } catch (const Error& error) {
      reasons += (reasons.empty() ? "" : " ") + std::string(error.what());
    }
  }
  throw Error(ExitCode::device, "OpenGL", "no device can be used. " + reasons);
}

} // namespace gg::gpu::opengl
