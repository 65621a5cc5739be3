#include "scene/gltf/draco.h"

#include "scene/gltf/accessors.h"
#include "scene/gltf/fail.h"

#include <draco/compression/decode.h>
#include <fmt/format.h>

#include <array>
#include <cmath>

namespace gg::scene::gltf {

struct DracoMesh::Decoded {
  std::unique_ptr<draco::Mesh> mesh;
};

DracoMesh::DracoMesh(std::span<const std::byte> bytes, const std::string& file,
                     const std::string& place)
    : decoded_(std::make_unique<Decoded>()), file_(file), place_(place) {
  draco::DecoderBuffer buffer;
  buffer.Init(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  const auto kind = draco::Decoder::GetEncodedGeometryType(&buffer);
  if (!kind.ok() || kind.value() != draco::TRIANGULAR_MESH)
    fail(file_, place_, "is not a Draco-compressed triangle mesh");
  try {
    draco::Decoder decoder;
    auto result = decoder.DecodeMeshFromBuffer(&buffer);
    if (!result.ok())
      fail(file_, place_, "the Draco data are damaged: " + result.status().error_msg_string());
    decoded_->mesh = std::move(result).value();
  } catch (const std::bad_alloc&) {
    fail(file_, place_, "the Draco data are damaged: they declare more than fits into memory");
  } catch (const std::length_error&) {
    fail(file_, place_, "the Draco data are damaged: they declare more than fits into memory");
  }
}

DracoMesh::~DracoMesh() = default;

std::size_t DracoMesh::point_count() const {
  return decoded_->mesh->num_points();
}

std::vector<std::uint32_t> DracoMesh::triangles() const {
  const draco::Mesh& mesh = *decoded_->mesh;
  std::vector<std::uint32_t> result;
  result.reserve(std::size_t{3} * mesh.num_faces());
  for (draco::FaceIndex f(0); f < mesh.num_faces(); ++f)
    for (const draco::PointIndex& p : mesh.face(f)) {
      if (p.value() >= mesh.num_points())
        fail(file_, place_, "the Draco data are damaged: a face names a point that is not there");
      result.push_back(p.value());
    }
  return result;
}

std::vector<float> DracoMesh::floats(int id, int components, bool normalise,
                                     int component_type) const {
  const draco::Mesh& mesh = *decoded_->mesh;
  const draco::PointAttribute* attribute =
      mesh.GetAttributeByUniqueId(static_cast<std::uint32_t>(id));
  if (attribute == nullptr)
    fail(file_, place_, fmt::format("has no attribute {} in its Draco data", id));
  if (attribute->num_components() != components)
    fail(file_, place_,
         fmt::format("attribute {} has {} components in its Draco data where {} are needed", id,
                     attribute->num_components(), components));
  const bool is_float = attribute->data_type() == draco::DT_FLOAT32;
  std::vector<float> result(mesh.num_points() * static_cast<std::size_t>(components));
  std::array<float, 4> values{};
  std::array<std::int64_t, 4> integers{};
  for (std::uint32_t point = 0; point < mesh.num_points(); ++point) {
    const auto entry = attribute->mapped_index(draco::PointIndex(point));
    if (entry.value() >= attribute->size())
      fail(file_, place_, "the Draco data are damaged: a point has no value");
    const bool converted =
        is_float ? attribute->ConvertValue<float>(entry, static_cast<std::int8_t>(components),
                                                  values.data())
                 : attribute->ConvertValue<std::int64_t>(
                     entry, static_cast<std::int8_t>(components), integers.data());
    if (!converted) fail(file_, place_, fmt::format("attribute {} cannot be read", id));
    for (std::size_t c = 0; c < static_cast<std::size_t>(components); ++c) {
      if (!is_float)
        values[c] =
            normalise ? normalised(integers[c], component_type) : static_cast<float>(integers[c]);
      if (!std::isfinite(values[c]))
        fail(file_, place_, fmt::format("attribute {} holds a value that is not finite", id));
      result[std::size_t{point} * static_cast<std::size_t>(components) + c] = values[c];
    }
  }
  return result;
}

} // namespace gg::scene::gltf
