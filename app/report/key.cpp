#include "report/key.h"

#include "core/files.h"
#include "scene/gltf/container.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <vector>

namespace gg::report {

namespace fs = std::filesystem;

void Key::mix(std::span<const std::byte> bytes) {
  for (const std::byte byte : bytes)
    hash_ = (hash_ ^ static_cast<std::uint64_t>(byte)) * 0x100000001b3ull;
}

Key& Key::add(std::span<const std::byte> bytes) {
  const std::uint64_t length = bytes.size();
  mix(std::as_bytes(std::span(&length, 1)));
  mix(bytes);
  return *this;
}

Key& Key::add(std::string_view text) {
  return add(std::as_bytes(std::span(text)));
}

Key& Key::add(double value) {
  const auto bits = std::bit_cast<std::uint64_t>(value);
  return add(std::as_bytes(std::span(&bits, 1)));
}

std::string Key::text() const {
  return fmt::format("{:016x}", hash_);
}

std::string key_of_gltf(const fs::path& path) {
  const scene::gltf::Container container = scene::gltf::open_container(path);
  Key key;
  key.add(container.bytes);
  for (const char* list : {"buffers", "images"}) {
    const auto found = container.json.find(list);
    if (found == container.json.end() || !found->is_array()) continue;
    for (std::size_t i = 0; i < found->size(); ++i) {
      const auto& entry = (*found)[i];
      const auto uri = entry.is_object() ? entry.find("uri") : entry.end();
      if (!entry.is_object() || uri == entry.end() || !uri->is_string()) continue;
      const std::string text = uri->get<std::string>();
      if (text.starts_with("data:")) continue; // a part of the file
      key.add(scene::gltf::fetch(text, container, fmt::format("{}[{}].uri", list, i)));
    }
  }
  return key.text();
}

std::string key_of_file(const fs::path& path) {
  return Key().add(read_file(path)).text();
}

std::string key_of_tree(const fs::path& directory) {
  std::vector<fs::path> files;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(directory))
    if (entry.is_regular_file()) files.push_back(entry.path());
  std::ranges::sort(files);
  Key key;
  for (const fs::path& file : files)
    key.add(file.lexically_relative(directory).generic_string()).add(read_file(file));
  return key.text();
}

std::string key_of_truth_program() {
  static constexpr std::string_view digest =
#include "truth_digest.inc"
      ;
  return Key().add(digest).text();
}

const std::string& key_of_frame_program() {
  static const std::string text = Key()
                                      .add(key_of_file("/proc/self/exe"))
                                      .add(key_of_tree(home_directory() / "shaders"))
                                      .add(key_of_tree(home_directory() / "assets/tables"))
                                      .text();
  return text;
}

} // namespace gg::report
