#include "image/exr_streams.h"

#include <OpenEXR/Iex.h>

#include <cstring>

namespace gg::image::formats {

bool MemoryInput::read(char* to, int count) {
  const std::uint64_t size = bytes_.size();
  if (count < 0 || at_ > size || static_cast<std::uint64_t>(count) > size - at_)
    throw Iex::InputExc("ends too soon");
  if (count > 0) std::memcpy(to, bytes_.data() + at_, static_cast<std::size_t>(count));
  at_ += static_cast<std::uint64_t>(count);
  return at_ < size;
}

void MemoryOutput::write(const char* from, int count) {
  if (count <= 0) return;
  const std::uint64_t end = at_ + static_cast<std::uint64_t>(count);
  if (end > bytes_.size()) bytes_.resize(end);
  std::memcpy(bytes_.data() + at_, from, static_cast<std::size_t>(count));
  at_ = end;
}

} // namespace gg::image::formats
