// A shared library opened at run time and never closed: drivers leave threads and exit handlers
// behind that outlive their last user.
#pragma once

#include <dlfcn.h>

#include <string>
#include <vector>

namespace gg {

class Library {
public:
  // The first of the names or paths that is there. RTLD_LOCAL: libOSMesa exports the names of all GL
  // functions, which must not stand in for those of another driver.
  explicit Library(const std::vector<std::string>& names) {
    for (const std::string& name : names)
      if (!handle_) handle_ = ::dlopen(name.c_str(), RTLD_NOW | RTLD_LOCAL);
  }

  explicit operator bool() const { return handle_ != nullptr; }

  // Null if it is not there.
  template <class Function>
  void load(Function& function, const char* name) const {
    function = handle_ ? reinterpret_cast<Function>(::dlsym(handle_, name)) : nullptr;
  }

private:
  void* handle_ = nullptr;
};

} // namespace gg
