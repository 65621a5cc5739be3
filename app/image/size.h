// How large an encoded picture is, before it is decoded.
#pragma once

#include <cstddef>
#include <string>

namespace gg::image {

// The size of what decode would give, by the head alone. Throws as decode where it cannot be told.
struct Size {
  int width = 0, height = 0;
  long long pixels() const { return static_cast<long long>(width) * height; }
};
Size size_of(const std::byte* data, std::size_t size, const std::string& name);

} // namespace gg::image
