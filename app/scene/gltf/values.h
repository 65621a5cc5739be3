// Reading extension members out of tinygltf's Value, after check() has vouched for their types.
#pragma once

#include "scene/gltf/tiny.h"

#include <glm/glm.hpp>

#include <string>
#include <vector>

namespace gg::scene::gltf {

inline float number_or(const tinygltf::Value& object, const char* key, float otherwise) {
  return object.Has(key) ? static_cast<float>(object.Get(key).GetNumberAsDouble()) : otherwise;
}

inline int integer_or(const tinygltf::Value& object, const char* key, int otherwise) {
  return object.Has(key) ? object.Get(key).GetNumberAsInt() : otherwise;
}

template <int N>
glm::vec<N, float> vector_or(const tinygltf::Value& object, const char* key,
                             glm::vec<N, float> otherwise) {
  if (object.Has(key))
    for (int i = 0; i < N; ++i)
      otherwise[i] = static_cast<float>(object.Get(key).Get(i).GetNumberAsDouble());
  return otherwise;
}

template <int N>
glm::vec<N, float> vector_of(const std::vector<double>& values) {
  glm::vec<N, float> v;
  for (int i = 0; i < N; ++i)
    v[i] = static_cast<float>(values[static_cast<std::size_t>(i)]);
  return v;
}

} // namespace gg::scene::gltf
