#include "robustness/samples.h"

#include "core/files.h"
#include "scene/grid.h"
#include "support/jpeg.h"
#include "support/scratch.h"

#include <webp/encode.h>

#include <cstdio>
#include <cstring>

namespace gg::test {

namespace {

std::vector<std::uint8_t> rgb(int width, int height) {
  std::vector<std::uint8_t> pixels(static_cast<std::size_t>(width * height) * 3);
  for (std::size_t i = 0; i < pixels.size(); ++i)
    pixels[i] = static_cast<std::uint8_t>(i * i / 7);
  return pixels;
}

Bytes copy(const void* data, std::size_t size) {
  Bytes bytes(size);
  std::memcpy(bytes.data(), data, size);
  return bytes;
}

} // namespace

GltfFile rich() {
  GltfFile file;
  const Grid grid(3);
  const std::size_t vertices = grid.positions.size() / 3;
  auto& j = file.json;
  j["materials"] = {{{"normalTexture", {{"index", 0}}},
                     {"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 1}}}}},
                     {"extensions",
                      {{"KHR_materials_volume", {{"thicknessFactor", 1}}},
                       {"KHR_materials_anisotropy", {{"anisotropyStrength", 0.5}}}}},
                     {"extras", {{"groundglass", {{"preset", "glass"}, {"color", {1, 1, 1}}}}}}}};
  j["textures"] = {{{"source", 0}, {"sampler", 0}},
                   {{"extensions", {{"EXT_texture_webp", {{"source", 0}}}}}}};
  j["samplers"] = {{{"minFilter", 9987}}};
  j["images"] = {{{"uri", "data:image/png;base64,"
                          "iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAIAAACQd1PeAAAADElEQVR42mP4z8AAAAMBAQD3"
                          "A0FDAAAAAElFTkSuQmCC"}}};
  auto first = plain(file, grid);
  std::vector<float> uvs;
  for (std::size_t i = 0; i < vertices; ++i)
    uvs.insert(uvs.end(), {grid.positions[3 * i], grid.positions[3 * i + 1]});
  first["attributes"]["TEXCOORD_0"] = file.accessor(uvs, "VEC2");
  first["material"] = 0;
  first["targets"] = {{{"POSITION", file.accessor(grid.normals, "VEC3")}}};
  file.mesh(first);
  j["meshes"][0]["weights"] = {0.5};

  auto second = with_meshopt(file, grid);
  second["attributes"]["JOINTS_0"] =
      file.accessor(std::vector<std::uint8_t>(4 * vertices, 0), "VEC4");
  second["attributes"]["WEIGHTS_0"] =
      file.accessor(std::vector<float>(4 * vertices, 0.25f), "VEC4");
  file.mesh(second);
  file.mesh(with_draco(file, grid));

  auto strip = plain(file, grid);
  strip["mode"] = 5;
  strip["attributes"].erase("NORMAL");
  const std::uint8_t places[] = {0, 5};
  const float moved[] = {1, 2, 3, 4, 5, 6};
  j["accessors"][strip["attributes"]["POSITION"].get<int>()]["sparse"] = {
      {"count", 2},
      {"indices", {{"bufferView", file.view(places, 2)}, {"componentType", 5121}}},
      {"values", {{"bufferView", file.view(moved, sizeof moved)}}}};
  file.mesh(strip);

  j["nodes"][1]["skin"] = 0;
  j["nodes"].push_back({{"camera", 0}, {"children", {5}}, {"rotation", {0, 0, 0, 1}}});
  j["nodes"].push_back({{"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}},
                        {"matrix", {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 1, 2, 3, 1}}});
  j["scenes"][0]["nodes"] = {0, 1, 2, 3, 4};
  j["skins"] = {{{"joints", {4, 5}}}};
  j["cameras"] = {{{"type", "perspective"}, {"perspective", {{"yfov", 1}, {"znear", 0.1}}}}};
  j["extensions"]["KHR_lights_punctual"]["lights"] = {
      {{"type", "spot"}, {"spot", {{"outerConeAngle", 0.5}}}}};
  return file;
}

GltfFile textured(const Bytes& picture, const char* mime_type) {
  GltfFile file;
  auto square = plain(file, Grid(2));
  square["attributes"]["TEXCOORD_0"] = file.accessor(
      std::vector<float>{0, 0, .5f, 0, 1, 0, 0, .5f, .5f, .5f, 1, .5f, 0, 1, .5f, 1, 1, 1}, "VEC2");
  square["material"] = 0;
  file.mesh(square);
  const int view = file.view(picture.data(), picture.size());
  file.json["materials"] = {{{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}}};
  file.json["textures"] = {{{"source", 0}}};
  file.json["images"] = {{{"bufferView", view}, {"mimeType", mime_type}}};
  return file;
}

image::Image sample(int width, int height) {
  image::Image image(width, height, 3);
  for (std::size_t i = 0; i < image.values.size(); ++i)
    image.values[i] = static_cast<float>(i % 97) * (i % 5 == 0 ? 0.0f : 0.03f);
  return image;
}

Bytes written(const char* extension) {
  const std::filesystem::path path = scratch_directory() / (std::string("whole") + extension);
  image::write(path, sample(33, 21));
  return read_file(path);
}

Bytes jpeg(bool progressive) {
  return jpeg_of(rgb(40, 30), {.quality = 75, .progressive = progressive});
}

Bytes webp(bool lossless) {
  const std::vector<std::uint8_t> pixels = rgb(40, 30);
  std::uint8_t* data = nullptr;
  const std::size_t size = lossless ? WebPEncodeLosslessRGB(pixels.data(), 40, 30, 120, &data)
                                    : WebPEncodeRGB(pixels.data(), 40, 30, 120, 80.0f, &data);
  const Bytes bytes = copy(data, size);
  WebPFree(data);
  return bytes;
}

Bytes ktx2() {
  return read_file(GROUNDGLASS_SOURCE_DIR "/tests/image/ktx2/uastc_zstd.ktx2");
}

} // namespace gg::test
