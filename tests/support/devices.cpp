#include "support/devices.h"

#include <gtest/gtest.h>

#include <map>
#include <memory>
#include <utility>

namespace gg::test {
namespace {

using Key = std::pair<gpu::Backend, gpu::Surface>;

class Devices : public ::testing::Environment {
public:
  gpu::Device& of(const Key& key) {
    std::unique_ptr<gpu::Device>& found = devices_[key];
    if (!found)
      found = gpu::create_device({.backend = key.first, .surface = key.second, .debug = true});
    return *found;
  }
  void TearDown() override { devices_.clear(); }

private:
  std::map<Key, std::unique_ptr<gpu::Device>> devices_;
};

Devices& devices() {
  static Devices* const registered = [] {
    auto* made = new Devices; // owned by gtest
    ::testing::AddGlobalTestEnvironment(made);
    return made;
  }();
  return *registered;
}

// Registered before the tests run, or gtest would not end it.
[[maybe_unused]] const Devices& at_start = devices();

} // namespace

gpu::Device& shared_device(gpu::Backend backend, gpu::Surface surface) {
  return devices().of({backend, surface});
}

} // namespace gg::test
