// How much memory a small file can make the program take.
#include "core/error.h"
#include "core/files.h"
#include "environment/map.h"
#include "image/image.h"
#include "robustness/counted.h"
#include "robustness/samples.h"
#include "scene/grid.h"
#include "scene/load.h"
#include "support/errors.h"
#include "support/scratch.h"

#include <draco/compression/encode.h>
#include <draco/mesh/mesh.h>
#include <gtest/gtest.h>

#include <limits>

using namespace gg;
using namespace gg::test;
using nlohmann::json;

namespace {

constexpr std::size_t mib = std::size_t{1} << 20;

Bytes bytes_of(std::string_view text) {
  Bytes bytes(text.size());
  std::memcpy(bytes.data(), text.data(), text.size());
  return bytes;
}

// A PNG of 16384 x 8192 pixels of one bit each, as far as its head goes: half a GiB once it is decoded. As long as deflate makes
// so many at least.
Bytes largest_png() {
  constexpr std::string_view head("\x89PNG\r\n\x1a\n\0\0\0\x0dIHDR\0\0\x40\0\0\0\x20\0\x01\0\0\0\0"
                                  "\x0a\x05\x61\xcc"
                                  "\0\0\x40\0IDAT",
                                  8 + 25 + 8);
  Bytes png = bytes_of(head);
  png.resize(16500);
  return png;
}

// One material that reads `count` times the same file as so many images.
GltfFile with_images(const Bytes& picture, int count) {
  GltfFile file = textured(picture, "image/png");
  json& j = file.json;
  for (int i = 1; i < count; ++i) {
    j["images"].push_back(j["images"][0]);
    j["textures"].push_back({{"source", i}});
  }
  json& material = j["materials"][0];
  const auto read = [&](json& in, const char* slot, int i) {
    if (i < count) in[slot] = {{"index", i}};
  };
  read(material["pbrMetallicRoughness"], "metallicRoughnessTexture", 1);
  read(material, "emissiveTexture", 2);
  read(material, "occlusionTexture", 3);
  read(material["extensions"]["KHR_materials_specular"], "specularTexture", 4);
  return file;
}

// A mesh by KHR_draco_mesh_compression, whose stream is this.
GltfFile with_draco_stream(const void* stream, std::size_t size) {
  GltfFile file;
  auto primitive = plain(file, Grid(2));
  primitive["extensions"]["KHR_draco_mesh_compression"] = {{"bufferView", file.view(stream, size)},
                                                           {"attributes", {{"POSITION", 0}}}};
  file.json["extensionsRequired"] = {"KHR_draco_mesh_compression"};
  file.mesh(primitive);
  return file;
}

void expect_refused_at_once(const GltfFile& file, const std::vector<std::string>& message) {
  const auto path = file.save();
  const Memory memory;
  EXPECT_TRUE(fails_with(ExitCode::input, message, [&] { scene::load(path); }));
  EXPECT_LT(memory.taken(), 64 * mib);
}

} // namespace

TEST(memory, pictures_of_a_scene_are_bounded_together) {
  const Bytes png = largest_png();
  // Four may be there: what is wrong is found where they are decoded.
  EXPECT_TRUE(fails_with(ExitCode::input, {"images[0]", "truncated or malformed"},
                         [&] { scene::load(with_images(png, 4).save()); }));
  expect_refused_at_once(with_images(png, 5), {"images[4]", "2560 MiB", "Scale them down"});
}

TEST(memory, draco_streams_declare_no_more_faces_than_their_size_can_pay_for) {
  // 2.2, a mesh; sequential: 2^30 faces and points; edgebreaker: 2^29 vertices, 2^30 faces, as many symbols.
  constexpr std::string_view faces = "\x80\x80\x80\x80\x04", half = "\x80\x80\x80\x80\x02";
  const std::string head = "DRACO\x02\x02\x01", flags(2, '\0'), zero(1, '\0'), rest(64, '\0');
  const std::string in_order = head + zero + flags + std::string(faces) + std::string(faces) + rest,
                    edgebreaker = head + "\x01" + flags + zero + std::string(half)
                                  + std::string(faces) + zero + std::string(faces) + rest;
  for (const std::string& stream : {in_order, edgebreaker})
    expect_refused_at_once(with_draco_stream(stream.data(), stream.size()),
                           {"KHR_draco_mesh_compression", "24576 MiB"});
}

// Constant attributes that glTF does not name compress to next to nothing.
TEST(memory, draco_attributes_take_no_more_than_their_size_can_pay_for) {
  const Grid grid(40);
  draco::Mesh mesh;
  const std::size_t points = grid.positions.size() / 3;
  mesh.set_num_points(static_cast<std::uint32_t>(points));
  for (std::size_t i = 0; i < grid.indices.size(); i += 3)
    mesh.AddFace({draco::PointIndex(grid.indices[i]), draco::PointIndex(grid.indices[i + 1]),
                  draco::PointIndex(grid.indices[i + 2])});
  const auto add = [&](draco::GeometryAttribute::Type type, draco::DataType of, std::int8_t count,
                       const auto& value_of) {
    draco::GeometryAttribute attribute;
    attribute.Init(type, nullptr, count, of, false, 4 * count, 0);
    draco::PointAttribute& values =
        *mesh.attribute(mesh.AddAttribute(attribute, true, static_cast<std::uint32_t>(points)));
    for (std::uint32_t i = 0; i < points; ++i)
      values.SetAttributeValue(draco::AttributeValueIndex(i), value_of(i));
  };
  add(draco::GeometryAttribute::POSITION, draco::DT_FLOAT32, 3,
      [&](std::uint32_t i) { return &grid.positions[3 * i]; });
  constexpr int extra = 50, components = 100; // of 12 bytes each: 101 MB
  const std::vector<std::int32_t> constant(components, 7);
  for (int i = 0; i < extra; ++i)
    add(draco::GeometryAttribute::GENERIC, draco::DT_INT32, components,
        [&](std::uint32_t) { return constant.data(); });
  for (const int method : {draco::MESH_SEQUENTIAL_ENCODING, draco::MESH_EDGEBREAKER_ENCODING}) {
    draco::Encoder encoder;
    encoder.SetEncodingMethod(method);
    draco::EncoderBuffer buffer;
    ASSERT_TRUE(encoder.EncodeMeshToBuffer(mesh, &buffer).ok());
    expect_refused_at_once(with_draco_stream(buffer.data(), buffer.size()),
                           {"KHR_draco_mesh_compression", "MiB"});
  }
}

TEST(memory, empty_elements_are_no_more_than_their_bytes_can_pay_for) {
  GltfFile file;
  file.triangle();
  file.json["materials"] = std::vector<json>(100'000, json::object());
  expect_refused_at_once(file, {"materials", "MiB"});
  file.json["materials"] = std::vector<json>(10'000, json::object());
  EXPECT_NO_THROW(scene::load(file.save()));
}

// Once, where it is read and mended: 16384 x 8192 pixels are accepted.
TEST(memory, a_panorama_is_held_once) {
  constexpr int width = 2048, height = 1024;
  image::Image panorama(width, height, 4);
  panorama.at(5, 5, 0) = std::numeric_limits<float>::quiet_NaN();
  const auto exr = scratch_directory() / "panorama.exr", hdr = scratch_directory() / "panorama.hdr";
  image::write(exr, panorama);
  panorama.at(5, 5, 0) = 1.0f;
  image::write(hdr, panorama);
  for (const auto& path : {exr, hdr}) {
    const Memory memory;
    EXPECT_EQ(environment::load(path).width, width);
    // A sixteenth for rows, blocks of the file and the like.
    EXPECT_LT(memory.taken(),
              panorama.values.size() * sizeof(float) * 17 / 16 + read_file(path).size())
        << path;
  }
}
