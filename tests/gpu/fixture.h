// What the tests of app/gpu share: every test runs on every backend and surface of this machine.
#pragma once

#include "gpu/device.h"

#include <gtest/gtest.h>

#include <cstring>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace gg::gpu {

struct Target {
  Backend backend = Backend::opengl;
  Surface surface = Surface::automatic;
};
std::string name_of(const testing::TestParamInfo<Target>& info); // "opengl_egl"
// OpenGL through EGL and OSMesa always, Vulkan if the machine lists a device of it.
std::vector<Target> targets();

// Whether a message says all of these.
testing::AssertionResult says(const std::string& message, const std::vector<std::string>& parts);

// A stage of tests/gpu/stages.
std::string stage(const std::string& file);

template <class T>
std::span<const std::byte> bytes_of(const std::vector<T>& values) {
  return std::as_bytes(std::span(values));
}
template <class T>
std::vector<T> values_of(const std::vector<std::byte>& bytes) {
  std::vector<T> values(bytes.size() / sizeof(T));
  std::memcpy(values.data(), bytes.data(), values.size() * sizeof(T));
  return values;
}

// One debug device per target, shared by the tests of a process.
class OnDevice : public testing::TestWithParam<Target> {
protected:
  Device& device();

  template <class T>
  BufferRef buffer(const std::string& label, const std::vector<T>& values, Use use) {
    return device().create(BufferDesc{label, values.size() * sizeof(T), use | Use::read_back},
                           bytes_of(values));
  }
  TextureRef target(const std::string& label, Format format, int width, int height);
  template <class T>
  std::vector<T> read(const TextureRef& texture, int level = 0, int layer = 0) {
    return values_of<T>(device().read(texture, level, layer));
  }
  template <class T>
  std::vector<T> read(const BufferRef& from) {
    return values_of<T>(device().read(from, 0, from->desc.bytes));
  }
  // Runs one pass.
  void run(const Pass& pass) { device().run(std::span(&pass, 1)); }
  // Draws `fragment` over the whole of `to`.
  void fill(const TextureRef& to, const std::string& fragment,
            const std::function<void(Encoder&)>& bind = {}, const std::vector<View>& reads = {},
            const std::vector<Constant>& constants = {});
};

// A vertex of stages/flat.vert.
struct FlatVertex {
  float position[3];
  float color[4];
};
PipelineDesc flat_pipeline(Format color);

} // namespace gg::gpu
