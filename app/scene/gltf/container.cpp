#include "scene/gltf/container.h"

#include "core/files.h"
#include "scene/gltf/fail.h"

#include <algorithm>
#include <cstring>
#include <string_view>

namespace gg::scene::gltf {
namespace {

constexpr std::uint32_t magic_glb = 0x46546C67;  // "glTF"
constexpr std::uint32_t chunk_json = 0x4E4F534A; // "JSON"
constexpr std::uint32_t chunk_binary = 0x004E4942;
constexpr std::size_t header_size = 12, chunk_header_size = 8;

// tinygltf follows nested extras by recursion. glTF itself nests about 10 deep; this leaves room
// for any application's extras and keeps the stack far from its end.
constexpr int deepest_nesting = 200;

std::uint32_t little_endian(std::span<const std::byte> bytes, std::size_t offset) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < 4; ++i)
    value |= std::to_integer<std::uint32_t>(bytes[offset + i]) << (8 * i);
  return value;
}

std::string_view text_of(std::span<const std::byte> bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

// Cuts the chunks of a .glb; returns the JSON text.
std::string_view cut_chunks(Container& c) {
  const std::span<const std::byte> bytes = c.bytes;
  if (bytes.size() < header_size + chunk_header_size)
    fail(c.name, "byte 0", "the .glb header is truncated", "Copy or export the file again.");
  if (const auto version = little_endian(bytes, 4); version != 2)
    fail(c.name, "byte 4", "is binary glTF version " + std::to_string(version),
         "Only glTF 2 is read: export it as glTF 2.0.");
  const std::size_t length = little_endian(bytes, 8);
  if (length > bytes.size())
    fail(c.name, "byte 8",
         "the header promises " + std::to_string(length) + " bytes, the file has "
             + std::to_string(bytes.size()),
         "The file is truncated: copy or export it again.");
  std::optional<std::string_view> content;
  for (std::size_t at = header_size; at + chunk_header_size <= length;) {
    const std::size_t size = little_endian(bytes, at);
    const std::uint32_t type = little_endian(bytes, at + 4);
    const std::size_t start = at + chunk_header_size;
    if (size > length - start)
      fail(c.name, "byte " + std::to_string(at),
           "a chunk of " + std::to_string(size) + " bytes does not fit into the "
               + std::to_string(length - start) + " that are left",
           "The file is truncated or damaged: copy or export it again.");
    if (!content && type != chunk_json)
      fail(c.name, "byte " + std::to_string(at), "the first chunk of a .glb must be JSON");
    if (!content)
      content = text_of(bytes.subspan(start, size));
    else if (type == chunk_binary && !c.payload)
      c.payload = bytes.subspan(start, size);
    at = start + size;
  }
  if (!content) fail(c.name, "byte 12", "the .glb has no JSON chunk");
  return *content;
}

std::string line_and_column(std::string_view text, std::size_t byte) {
  const std::string_view before = text.substr(0, std::min(byte, text.size()));
  const auto line = std::count(before.begin(), before.end(), '\n') + 1;
  const auto start = before.rfind('\n');
  const auto column = start == std::string_view::npos ? before.size() : before.size() - start - 1;
  return "line " + std::to_string(line) + ", column " + std::to_string(column);
}

void check_nesting(std::string_view text, const std::string& name) {
  int depth = 0;
  bool in_string = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char ch = text[i];
    if (in_string) {
      if (ch == '\\')
        ++i;
      else
        in_string = ch != '"';
    } else if (ch == '"') {
      in_string = true;
    } else if (ch == '[' || ch == '{') {
      if (++depth > deepest_nesting)
        fail(name, line_and_column(text, i),
             "nests more than " + std::to_string(deepest_nesting) + " levels deep",
             "Remove the nested extras.");
    } else if (ch == ']' || ch == '}') {
      --depth;
    }
  }
}

nlohmann::json parse(std::string_view text, const std::string& name) {
  while (!text.empty() && text.back() == '\0') // some writers pad with zeros instead of spaces
    text.remove_suffix(1);
  check_nesting(text, name);
  try {
    return nlohmann::json::parse(text);
  } catch (const nlohmann::json::parse_error& error) {
    fail(name, line_and_column(text, error.byte), "is not valid JSON",
         "Is it a glTF file? " + std::string(export_again));
  } catch (const nlohmann::json::exception&) {
    fail(name, "", "contains a number that is out of range");
  }
}

} // namespace

Container open_container(const std::filesystem::path& path) {
  Container c;
  c.name = path.string();
  c.directory = path.parent_path();
  c.bytes = read_file(path);
  if (c.bytes.empty()) fail(c.name, "", "is empty", "Copy or export the file again.");
  const bool binary = c.bytes.size() >= 4 && little_endian(c.bytes, 0) == magic_glb;
  c.json = parse(binary ? cut_chunks(c) : text_of(c.bytes), c.name);
  return c;
}

} // namespace gg::scene::gltf
