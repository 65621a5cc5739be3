// A shared library opened at run time and never closed: drivers leave threads and exit handlers
// behind that outlive their last user.
#pragma once

#include <dlfcn.h>

#include <initializer_list>

namespace gg::gpu::surface {

class Library {
public:
  // The first of the names that is there. RTLD_LOCAL: libOSMesa exports the names of all GL
  // functions, which must not stand in for those of another driver.
  explicit Library(std::initializer_list<const char*> names) {
    for (const char* name : names)
      if (!handle_) handle_ = ::dlopen(name, RTLD_NOW | RTLD_LOCAL);
  }

  explicit operator bool() const { return handle_ != nullptr; }

  template <class Function>
  void load(Function& function, const char* name) const {
    function = handle_ ? reinterpret_cast<Function>(::dlsym(handle_, name)) : nullptr;
  }

private:
  void* handle_ = nullptr;
};

} // namespace gg::gpu::surface
