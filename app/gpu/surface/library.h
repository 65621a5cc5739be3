// A shared library opened at run time and never closed: drivers leave threads and exit handlers
// behind that outlive their last user.
#pragma once

#include <dlfcn.h>

namespace gg::gpu::surface {

class Library {
public:
  // RTLD_LOCAL: libOSMesa exports the names of all GL functions, which must not stand in for those
  // of another driver.
  explicit Library(const char* name) : handle_(::dlopen(name, RTLD_NOW | RTLD_LOCAL)) {}

  explicit operator bool() const { return handle_ != nullptr; }

  template <class Function>
  void load(Function& function, const char* name) const {
    function = handle_ ? reinterpret_cast<Function>(::dlsym(handle_, name)) : nullptr;
  }

private:
  void* handle_;
};

} // namespace gg::gpu::surface
