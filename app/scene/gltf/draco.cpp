#include "scene/gltf/draco.h"

#include "scene/gltf/accessors.h"
#include "scene/gltf/fail.h"

#include <draco/compression/decode.h>
#include <draco/compression/mesh/mesh_edgebreaker_decoder.h>
#include <draco/compression/mesh/mesh_sequential_decoder.h>
#include <draco/core/varint_decoding.h>
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <exception>

namespace gg::scene::gltf {
namespace {

// A stream of a hundred bytes can declare 2^30 faces, or thousands of attributes of each point, and Draco takes memory for them
// before it reads them. These ask first. No exception passes through the library: what was thrown is kept.
template <class Decoder>
class Asking : public Decoder {
public:
  explicit Asking(const Afford& afford) : afford_(afford) {}
  std::exception_ptr refusal() const { return refusal_; }

protected:
  // Edgebreaker's table of corners: the vertex of each and the corner opposite. In order: three indices of each face, twice while
  // they are decompressed.
  static constexpr std::size_t bytes_of_face = 24;

  bool DecodeGeometryData() override {
    return allows(bytes_of_face * declared_faces()) && Decoder::DecodeGeometryData();
  }

  // Each value as it is stored and as an integer, before and after its correction is predicted.
  bool DecodeAllAttributes() override {
    std::size_t bytes = 0;
    const draco::PointCloud& points = *this->point_cloud();
    for (int i = 0; i < points.num_attributes(); ++i)
      bytes += points.num_points()
               * (static_cast<std::size_t>(points.attribute(i)->byte_stride())
                  + 2 * sizeof(std::int32_t)
                        * static_cast<std::size_t>(points.attribute(i)->num_components()));
    return allows(bytes) && Decoder::DecodeAllAttributes();
  }

private:
  // Peeks at the head of the connectivity, whose numbers older streams have with 32 bits.
  std::size_t declared_faces() {
    draco::DecoderBuffer head = *this->buffer();
    const auto version = this->bitstream_version();
    const auto next = [&](int packed_since) {
      std::uint32_t value = 0;
      const bool read =
          version < packed_since ? head.Decode(&value) : draco::DecodeVarint(&value, &head);
      return read ? value : 0;
    };
    constexpr int two = DRACO_BITSTREAM_VERSION(2, 0), two_two = DRACO_BITSTREAM_VERSION(2, 2);
    if constexpr (std::is_same_v<Decoder, draco::MeshEdgebreakerDecoder>) {
      if (version < two_two) next(two); // vertices that splits add
      next(two);                        // vertices
      return next(two);
    } else {
      return next(two_two);
    }
  }

  bool allows(std::size_t bytes) {
    try {
      afford_(bytes);
      return true;
    } catch (...) {
      refusal_ = std::current_exception();
      return false;
    }
  }

  const Afford& afford_;
  std::exception_ptr refusal_;
};

// Throws what refused it.
template <class Decoder>
draco::Status decode(draco::DecoderBuffer& buffer, draco::Mesh& mesh, const Afford& afford) {
  Asking<Decoder> decoder(afford);
  const draco::Status status = decoder.Decode(draco::DecoderOptions(), &buffer, &mesh);
  if (decoder.refusal()) std::rethrow_exception(decoder.refusal());
  return status;
}

} // namespace

struct DracoMesh::Decoded {
  std::unique_ptr<draco::Mesh> mesh;
};

DracoMesh::DracoMesh(std::span<const std::byte> bytes, const std::string& file,
                     const std::string& place, const Afford& afford)
    : decoded_(std::make_unique<Decoded>()), file_(file), place_(place) {
  draco::DecoderBuffer buffer;
  buffer.Init(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  draco::DecoderBuffer ahead = buffer;
  draco::DracoHeader head;
  if (!draco::PointCloudDecoder::DecodeHeader(&ahead, &head).ok()
      || head.encoder_type != draco::TRIANGULAR_MESH)
    fail(file_, place_, "is not a Draco-compressed triangle mesh");
  if (head.encoder_method > draco::MESH_EDGEBREAKER_ENCODING)
    fail(file_, place_,
         fmt::format("is compressed by Draco's method {}, which does not exist",
                     head.encoder_method));
  try {
    decoded_->mesh = std::make_unique<draco::Mesh>();
    const draco::Status status =
        head.encoder_method == draco::MESH_SEQUENTIAL_ENCODING
            ? decode<draco::MeshSequentialDecoder>(buffer, *decoded_->mesh, afford)
            : decode<draco::MeshEdgebreakerDecoder>(buffer, *decoded_->mesh, afford);
    if (!status.ok())
      fail(file_, place_, "the Draco data are damaged: " + status.error_msg_string());
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
