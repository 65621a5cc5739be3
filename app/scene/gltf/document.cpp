#include "scene/gltf/document.h"

#include "image/image.h"
#include "scene/gltf/check.h"
#include "scene/gltf/extensions.h"
#include "scene/gltf/fail.h"
#include "scene/gltf/meshopt.h"

#include <fmt/format.h>

#include <algorithm>

namespace gg::scene::gltf {
namespace {

// What a byte of input may unpack to. meshopt's vertex codec spends at least 1/64 byte per byte,
// quantised bytes become floats (4), and files like MetalRoughSpheresNoTextures read a vertex from
// several accessors; the constant part lets small files hold zero-filled accessors.
constexpr std::size_t expansion = 256, allowance = std::size_t{64} << 20;
// What its pictures may unpack to before that counts too: plain ones compress much better (deflate 1032 times). Four of the
// largest, thirty-two of 4096 x 4096.
constexpr std::size_t picture_allowance = 4 * 4 * static_cast<std::size_t>(image::max_pixels);

// What tinygltf is given: the structure without what it would read, decode or drop by itself.
std::string structure(const nlohmann::json& json) {
  nlohmann::json copy = json;
  for (const char* bytes : {"buffers", "images", "animations"})
    copy.erase(bytes);
  // tinygltf refuses indices without a buffer view, which is what Draco primitives have; they are
  // read from the compressed data.
  if (copy.contains("meshes"))
    for (auto& mesh : copy["meshes"])
      for (auto& primitive : mesh["primitives"])
        if (primitive.contains("extensions")
            && primitive["extensions"].contains("KHR_draco_mesh_compression"))
          primitive.erase("indices");
  return copy.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

} // namespace

Document::Document(const std::filesystem::path& path) : container_(open_container(path)) {
  const auto& json = container_.json;
  if (!json.is_object() || !json.contains("asset"))
    fail(name(), "asset", "is missing: this is not a glTF 2.0 file");
  camera_faults_ = mend(container_.json, name());
  check(json, name());
  if (const auto version = json["asset"]["version"].get<std::string>(); !version.starts_with("2."))
    fail_unsupported(name(), "asset.version", "is '" + version.substr(0, 20) + "'",
                     "Only glTF 2 is read: export it as glTF 2.0.");
  if (const std::string least = json["asset"].value("minVersion", "2.0"); least > "2.0")
    fail_unsupported(name(), "asset.minVersion", "is '" + least.substr(0, 20) + "'",
                     "Only glTF 2.0 is read: export it as that.");
  check_extensions(json, name());

  read_ = container_.bytes.size();
  afford_elements();
  const std::string text = structure(json);
  std::string error, warning;
  tinygltf::TinyGLTF reader;
  if (!reader.LoadASCIIFromString(&model_, &error, &warning, text.data(),
                                  static_cast<unsigned>(text.size()), ""))
    fail(name(), "", "is not valid glTF: " + error.substr(0, error.find('\n')));
}

// "{}," is three bytes of the file and a structure of tinygltf's and one of ours.
void Document::afford_elements() const {
  // Measured with a million of each: 3400 bytes a material, 780 a node, the largest of the others.
  constexpr std::size_t bytes_of_material = 4096, bytes_of_another = 1024;
  std::size_t bytes = 0;
  for (const auto& [member, elements] : container_.json.items()) {
    if (!elements.is_array()) continue;
    bytes += elements.size() * (member == "materials" ? bytes_of_material : bytes_of_another);
    afford(bytes, member);
  }
}

std::size_t Document::left() const {
  return allowance + expansion * read_ - spent_;
}

void Document::spend(std::size_t bytes, const std::string& place) {
  afford(bytes, place);
  spent_ += bytes;
}

void Document::afford(std::size_t bytes, const std::string& place) const {
  if (bytes > left())
    fail(name(), place,
         fmt::format("asks for {} MiB, in a file of {} KiB", bytes >> 20, read_ >> 10),
         "Check its count: the file does not hold that much.");
}

void Document::spend_on_picture(std::size_t bytes, const std::string& place) {
  const std::size_t free = std::min(bytes, picture_allowance - pictures_), rest = bytes - free;
  if (rest > left())
    fail(name(), place,
         fmt::format("is one picture too many: with it they take {} MiB, in files of {} KiB",
                     (picture_allowance + spent_ + rest) >> 20, read_ >> 10),
         "Scale them down.");
  pictures_ += free;
  spent_ += rest;
  kept_ += rest;
}

std::string Document::camera_fault(int camera) const {
  const auto found = camera_faults_.find(camera);
  return found == camera_faults_.end() ? std::string() : found->second;
}

std::vector<nlohmann::json> Document::animations() const {
  const auto found = container_.json.find("animations");
  if (found == container_.json.end() || !found->is_array()) return {};
  return *found;
}

const nlohmann::json& Document::animation(std::size_t index) const {
  check_animation(container_.json, index, name());
  return container_.json["animations"][index];
}

std::span<const std::byte> Document::buffer(int buffer) {
  const std::string place = element("buffers", buffer);
  const auto& json = container_.json["buffers"][static_cast<std::size_t>(buffer)];
  const std::size_t length = json["byteLength"].get<std::size_t>();
  std::span<const std::byte> bytes;
  if (json.contains("uri")) {
    auto found = buffers_.find(buffer);
    if (found == buffers_.end()) {
      const auto& uri = json["uri"].get_ref<const std::string&>();
      found = buffers_.emplace(buffer, fetch(uri, container_, place + ".uri")).first;
      read_ += found->second.size();
    }
    bytes = found->second;
  } else if (buffer == 0 && container_.payload) {
    bytes = *container_.payload;
  } else {
    fail(name(), place, "has neither a uri nor a BIN chunk to read from");
  }
  if (length > bytes.size())
    fail(name(), place + ".byteLength",
         fmt::format("is {}, and there are {} bytes", length, bytes.size()),
         "The data are truncated: copy or export the file again.");
  return bytes.first(length);
}

std::span<const std::byte> Document::slice(int index, std::size_t offset, std::size_t length,
                                           const std::string& place) {
  const auto bytes = buffer(index);
  if (offset > bytes.size() || length > bytes.size() - offset)
    fail(name(), place,
         fmt::format("reaches from byte {} to {} of buffers[{}], which has {}", offset,
                     offset + length, index, bytes.size()));
  return bytes.subspan(offset, length);
}

std::span<const std::byte> Document::view(int index) {
  const std::string place = element("bufferViews", index);
  const auto& json = container_.json["bufferViews"][static_cast<std::size_t>(index)];
  if (json.contains("extensions") && json["extensions"].contains("EXT_meshopt_compression")) {
    auto found = decompressed_.find(index);
    if (found == decompressed_.end()) {
      const std::string at = place + ".extensions.EXT_meshopt_compression";
      const auto& extension = json["extensions"]["EXT_meshopt_compression"];
      const Meshopt stream = meshopt_stream(extension, name(), at);
      spend(stream.count * stream.stride, at);
      kept_ += stream.count * stream.stride;
      const auto source =
          slice(extension["buffer"].get<int>(), extension.value("byteOffset", std::size_t{0}),
                extension["byteLength"].get<std::size_t>(), at);
      found = decompressed_.emplace(index, decode_meshopt(stream, source, name(), at)).first;
    }
    return found->second;
  }
  return slice(json["buffer"].get<int>(), json.value("byteOffset", std::size_t{0}),
               json["byteLength"].get<std::size_t>(), place);
}

std::span<const std::byte> Document::image(int index) {
  const std::string place = element("images", index);
  const auto& json = container_.json["images"][static_cast<std::size_t>(index)];
  if (json.contains("bufferView")) return view(json["bufferView"].get<int>());
  if (!json.contains("uri")) fail(name(), place, "has neither a uri nor a bufferView");
  auto found = external_images_.find(index);
  if (found == external_images_.end()) {
    const auto& uri = json["uri"].get_ref<const std::string&>();
    found = external_images_.emplace(index, fetch(uri, container_, place + ".uri")).first;
    read_ += found->second.size();
  }
  return found->second;
}

} // namespace gg::scene::gltf
