// Queries and answers as shaders/interface/queries.glsl lays them out.
#pragma once

#include "bsdf/query.h"

#include <glm/vec4.hpp>

#include <cstddef>
#include <limits>

namespace gg::bsdf {
namespace interface {
using glm::vec4;
#include "../../shaders/interface/queries.glsl"
} // namespace interface

using interface::PackedQuery;
using interface::PackedValues;
static_assert(sizeof(PackedQuery) == 64 && offsetof(PackedQuery, rest) == 48);
static_assert(sizeof(PackedValues) == 48 && offsetof(PackedValues, third) == 32);

inline PackedQuery pack(const Query& q) {
  return {{q.i[0], q.i[1], q.i[2], q.alpha},
          {q.o[0], q.o[1], q.o[2], q.eta},
          {q.n[0], q.n[1], q.n[2], q.cn},
          {q.ck, static_cast<float>(q.lobe), static_cast<float>(q.distribution), 0.0f}};
}

// A value beyond float32's range is answered with the largest number in it.
inline Values<float> unpack(const PackedValues& v) {
  Values<float> values = {v.first.x,  v.first.y,  v.first.z,  v.first.w, v.second.x,
                          v.second.y, v.second.z, v.second.w, v.third.x, v.third.y};
  for (float& value : values)
    if (value > std::numeric_limits<float>::max()) value = std::numeric_limits<float>::max();
  return values;
}

} // namespace gg::bsdf
