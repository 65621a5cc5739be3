#include "scene/gltf/accessors.h"

#include "scene/gltf/fail.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>

namespace gg::scene::gltf {
namespace {

std::size_t component_size(int type) {
  switch (type) {
  case TINYGLTF_COMPONENT_TYPE_BYTE:
  case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
    return 1;
  case TINYGLTF_COMPONENT_TYPE_SHORT:
  case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
    return 2;
  default:
    return 4;
  }
}

// Where the numbers of an accessor lie: `count` elements of `columns` x `rows` components.
struct Layout {
  std::size_t count, columns, rows, size; // size of a component
  int type;
  std::size_t column_stride, element_size, stride;
  std::size_t components() const { return columns * rows; }
};

Layout layout(const tinygltf::Accessor& accessor) {
  Layout l{};
  l.count = accessor.count;
  l.type = accessor.componentType;
  l.size = component_size(l.type);
  switch (accessor.type) {
  case TINYGLTF_TYPE_MAT2:
    l.columns = l.rows = 2;
    break;
  case TINYGLTF_TYPE_MAT3:
    l.columns = l.rows = 3;
    break;
  case TINYGLTF_TYPE_MAT4:
    l.columns = l.rows = 4;
    break;
  default:
    l.columns = 1;
    l.rows = static_cast<std::size_t>(accessor.type == TINYGLTF_TYPE_SCALAR ? 1 : accessor.type);
  }
  // Columns of matrices start at multiples of four bytes (§3.6.2.4).
  l.column_stride = l.columns == 1 ? l.rows * l.size : (l.rows * l.size + 3) / 4 * 4;
  l.element_size = l.columns * l.column_stride;
  l.stride = l.element_size;
  return l;
}

// The bytes from the first element to the last. `view` is the accessor's, or that of its sparse
// values, which are always packed.
std::span<const std::byte> locate(Document& document, const Layout& l, int view, std::size_t offset,
                                  const std::string& place) {
  if (l.stride < l.element_size)
    fail(document.name(), element("bufferViews", view) + ".byteStride",
         fmt::format("is {}, less than the {} bytes of an element of {}", l.stride, l.element_size,
                     place));
  const auto bytes = document.view(view);
  // count <= 2^53 (schema) and stride <= 256, so the product fits 64 bits.
  const std::size_t needed = (l.count - 1) * l.stride + l.element_size;
  if (offset > bytes.size() || needed > bytes.size() - offset)
    fail(document.name(), place,
         fmt::format("needs {} bytes from byte {} of bufferViews[{}], which has {}", needed, offset,
                     view, bytes.size()),
         "Its count, type or byteOffset is wrong, or the data are truncated: export it again.");
  return bytes.subspan(offset, needed);
}

template <class Component>
Component load(const std::byte* at) {
  Component value;
  std::memcpy(&value, at, sizeof value);
  return value;
}

// Calls store(index of the value, component) for each component; the loop is compiled once per
// component type.
template <class Component, class Store>
void each(const Layout& l, std::span<const std::byte> bytes, const Store& store) {
  std::size_t next = 0;
  for (std::size_t i = 0; i < l.count; ++i)
    for (std::size_t column = 0; column < l.columns; ++column) {
      const std::byte* at = bytes.data() + i * l.stride + column * l.column_stride;
      for (std::size_t row = 0; row < l.rows; ++row, at += sizeof(Component))
        store(next++, load<Component>(at));
    }
}

template <class Store>
void each(const Layout& l, std::span<const std::byte> bytes, const std::string& file,
          const std::string& place, const Store& store) {
  switch (l.type) {
  case TINYGLTF_COMPONENT_TYPE_BYTE:
    return each<std::int8_t>(l, bytes, store);
  case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
    return each<std::uint8_t>(l, bytes, store);
  case TINYGLTF_COMPONENT_TYPE_SHORT:
    return each<std::int16_t>(l, bytes, store);
  case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
    return each<std::uint16_t>(l, bytes, store);
  case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
    return each<std::uint32_t>(l, bytes, store);
  case TINYGLTF_COMPONENT_TYPE_FLOAT:
    return each<float>(l, bytes, store);
  default:
    fail(file, place + ".componentType", fmt::format("is {}, which glTF does not have", l.type));
  }
}

template <class Store>
void values(Document& document, const Layout& l, int view, std::size_t offset, bool normalise,
            const std::string& place, const Store& store) {
  const auto bytes = locate(document, l, view, offset, place);
  each(l, bytes, document.name(), place, [&](std::size_t i, auto component) {
    if constexpr (std::is_same_v<decltype(component), float>) {
      if (!std::isfinite(component))
        fail(document.name(), place, fmt::format("value {} is not a finite number", i));
      store(i, component);
    } else {
      store(i, normalise ? normalised(component, l.type) : static_cast<float>(component));
    }
  });
}

// The elements that a sparse accessor replaces: strictly increasing (§3.6.2.3).
std::vector<std::uint32_t> sparse_places(Document& document, const tinygltf::Accessor& accessor,
                                         const std::string& place) {
  tinygltf::Accessor indices;
  indices.count = static_cast<std::size_t>(accessor.sparse.count);
  indices.componentType = accessor.sparse.indices.componentType;
  indices.type = TINYGLTF_TYPE_SCALAR;
  const Layout l = layout(indices);
  const auto bytes = locate(document, l, accessor.sparse.indices.bufferView,
                            static_cast<std::size_t>(accessor.sparse.indices.byteOffset), place);
  std::vector<std::uint32_t> places;
  each(l, bytes, document.name(), place, [&](std::size_t i, auto component) {
    const auto at = static_cast<double>(component);
    if (!(at >= 0 && at < static_cast<double>(accessor.count))
        || (i > 0 && at <= static_cast<double>(places.back())))
      fail(document.name(), place,
           fmt::format("value {} is out of order or beyond the {} elements", i, accessor.count));
    places.push_back(static_cast<std::uint32_t>(component));
  });
  return places;
}

} // namespace

int component_count(const tinygltf::Accessor& accessor) {
  return static_cast<int>(layout(accessor).components());
}

float normalised(std::int64_t value, int component_type) {
  const auto v = static_cast<double>(value);
  switch (component_type) {
  case TINYGLTF_COMPONENT_TYPE_BYTE:
    return static_cast<float>(std::max(v / 127.0, -1.0));
  case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
    return static_cast<float>(v / 255.0);
  case TINYGLTF_COMPONENT_TYPE_SHORT:
    return static_cast<float>(std::max(v / 32767.0, -1.0));
  case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
    return static_cast<float>(v / 65535.0);
  default:
    return static_cast<float>(v / 4294967295.0);
  }
}

std::vector<float> read_floats(Document& document, int index) {
  const auto& accessor = document.model().accessors[static_cast<std::size_t>(index)];
  const std::string place = element("accessors", index);
  Layout l = layout(accessor);
  if (accessor.bufferView >= 0) {
    const auto& view = document.model().bufferViews[static_cast<std::size_t>(accessor.bufferView)];
    if (view.byteStride != 0) l.stride = view.byteStride;
    locate(document, l, accessor.bufferView, accessor.byteOffset, place);
  }
  document.spend(l.count * l.components() * sizeof(float), place + ".count");
  std::vector<float> result(l.count * l.components());
  if (accessor.bufferView >= 0)
    values(document, l, accessor.bufferView, accessor.byteOffset, accessor.normalized, place,
           [&](std::size_t i, float value) { result[i] = value; });
  if (accessor.sparse.isSparse) {
    const auto places = sparse_places(document, accessor, place + ".sparse.indices");
    Layout packed = layout(accessor);
    packed.count = places.size();
    values(document, packed, accessor.sparse.values.bufferView,
           static_cast<std::size_t>(accessor.sparse.values.byteOffset), accessor.normalized,
           place + ".sparse.values", [&](std::size_t i, float value) {
             const std::size_t width = l.components();
             result[places[i / width] * width + i % width] = value;
           });
  }
  return result;
}

std::vector<std::uint32_t> read_integers(Document& document, int index) {
  const auto& accessor = document.model().accessors[static_cast<std::size_t>(index)];
  const std::string place = element("accessors", index);
  if (accessor.componentType != TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE
      && accessor.componentType != TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT
      && accessor.componentType != TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT)
    fail(document.name(), place + ".componentType", "must be an unsigned integer here");
  Layout l = layout(accessor);
  if (accessor.bufferView < 0 || accessor.sparse.isSparse) {
    // Rare for indices and joints; 24 bits hold them exactly in the float path, and more than 2^24
    // sparse vertices are refused by the check below.
    const std::vector<float> floats = read_floats(document, index);
    constexpr float exact = 16777216.0f;
    std::vector<std::uint32_t> result(floats.size());
    for (std::size_t i = 0; i < floats.size(); ++i) {
      if (floats[i] > exact)
        fail(document.name(), place, "sparse integers beyond 2^24 are not read");
      result[i] = static_cast<std::uint32_t>(floats[i]);
    }
    return result;
  }
  const auto& view = document.model().bufferViews[static_cast<std::size_t>(accessor.bufferView)];
  if (view.byteStride != 0) l.stride = view.byteStride;
  const auto bytes = locate(document, l, accessor.bufferView, accessor.byteOffset, place);
  document.spend(l.count * l.components() * sizeof(std::uint32_t), place + ".count");
  std::vector<std::uint32_t> result(l.count * l.components());
  each(l, bytes, document.name(), place,
       [&](std::size_t i, auto component) { result[i] = static_cast<std::uint32_t>(component); });
  return result;
}

} // namespace gg::scene::gltf
