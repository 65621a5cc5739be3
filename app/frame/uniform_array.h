// Uniform data of many things in one buffer, each at an offset that may be bound.
#pragma once

#include "gpu/device.h"

#include <algorithm>
#include <cstring>
#include <string>
#include <vector>

namespace gg::frame {

struct UniformArray {
  gpu::BufferRef buffer;
  std::size_t stride = 0, size = 0; // bytes
  std::size_t offset(std::size_t i) const { return i * stride; }
};

// Puts `values` into the buffer, or into a new one where they are more than it holds, which then has room for as many again: what
// is seen changes with every turn of a camera. `values` may be empty: the buffer then holds one element of zeros.
template <class T>
void update_uniforms(gpu::Device& device, UniformArray& array, const std::string& label,
                     const std::vector<T>& values) {
  array.size = sizeof(T);
  array.stride =
      (sizeof(T) + gpu::block_alignment - 1) / gpu::block_alignment * gpu::block_alignment;
  std::vector<std::byte> padded(array.stride * std::max<std::size_t>(values.size(), 1));
  for (std::size_t i = 0; i < values.size(); ++i)
    std::memcpy(&padded[array.offset(i)], &values[i], sizeof(T));
  if (array.buffer && array.buffer->desc.bytes >= padded.size()) {
    device.upload(array.buffer, 0, padded);
    return;
  }
  const std::size_t bytes = array.buffer ? 2 * padded.size() : padded.size();
  array.buffer = device.create(gpu::BufferDesc{label, bytes, gpu::Use::uniforms}, padded);
}

} // namespace gg::frame
