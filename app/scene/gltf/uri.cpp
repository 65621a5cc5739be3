// URIs in glTF: data: URIs and files at or below the scene's directory.
#include "core/files.h"
#include "scene/gltf/container.h"
#include "scene/gltf/fail.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <string_view>

namespace gg::scene::gltf {
namespace {

// RFC 4648, with or without padding. Empty if a character does not belong.
std::optional<std::vector<std::byte>> decode_base64(std::string_view text) {
  static constexpr std::string_view alphabet =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::array<int, 256> digit;
  digit.fill(-1);
  for (std::size_t i = 0; i < alphabet.size(); ++i)
    digit[static_cast<unsigned char>(alphabet[i])] = static_cast<int>(i);
  while (!text.empty() && text.back() == '=')
    text.remove_suffix(1);
  if (text.size() % 4 == 1) return std::nullopt;
  std::vector<std::byte> bytes;
  bytes.reserve(text.size() / 4 * 3 + 2);
  std::uint32_t bits = 0;
  int held = 0;
  for (const char ch : text) {
    const int value = digit[static_cast<unsigned char>(ch)];
    if (value < 0) return std::nullopt;
    bits = (bits << 6 | static_cast<std::uint32_t>(value)) & 0xFFFFFF;
    if ((held += 6) >= 8) {
      held -= 8;
      bytes.push_back(static_cast<std::byte>(bits >> held & 0xFF));
    }
  }
  return bytes;
}

int hexadecimal(char ch) {
  if (ch >= '0' && ch <= '9') return ch - '0';
  const int lower = std::tolower(static_cast<unsigned char>(ch));
  return lower >= 'a' && lower <= 'f' ? lower - 'a' + 10 : -1;
}

// RFC 3986 percent-decoding; a stray % stands for itself, as exporters that do not encode write it.
std::string decode_percent(std::string_view text) {
  std::string result;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '%' && i + 2 < text.size() && hexadecimal(text[i + 1]) >= 0
        && hexadecimal(text[i + 2]) >= 0) {
      result += static_cast<char>(hexadecimal(text[i + 1]) * 16 + hexadecimal(text[i + 2]));
      i += 2;
    } else {
      result += text[i];
    }
  }
  return result;
}

std::string lower_case(std::string_view text) {
  std::string result(text);
  for (char& ch : result)
    ch = static_cast<char>(std::tolower(static_cast<unsigned char>(ch)));
  return result;
}

// Scheme and media type are of any case (RFC 3986 §3.1, RFC 2045 §5.1 and §6.1). Base64 may be broken into lines
// (RFC 2045 §6.8), and be percent-encoded as the rest of a URI.
std::vector<std::byte> data_uri(std::string_view uri, const std::string& file,
                                const std::string& place) {
  const auto comma = uri.find(',');
  const std::string head = lower_case(uri.substr(0, comma));
  if (comma == std::string_view::npos || !head.ends_with(";base64"))
    fail(file, place, "the data: URI is not base64");
  std::string text(uri.substr(comma + 1));
  if (text.find('%') != std::string::npos) text = decode_percent(text);
  const auto breaks = std::erase_if(
      text, [](char ch) { return ch == '\n' || ch == '\r' || ch == ' ' || ch == '\t'; });
  auto bytes = decode_base64(text);
  if (!bytes) fail(file, place, "the base64 text of the data: URI is broken");
  if (breaks != 0 || !uri.starts_with("data:") || !uri.substr(0, comma).ends_with(";base64"))
    note(file + ": " + place + " is a data: URI with line breaks or capitals; read all the same");
  return std::move(*bytes);
}

bool has_scheme(std::string_view uri) {
  const auto colon = uri.find(':');
  return colon != std::string_view::npos && colon > 1
         && std::all_of(uri.begin(), uri.begin() + static_cast<std::ptrdiff_t>(colon), [](char ch) {
              return std::isalnum(static_cast<unsigned char>(ch)) || ch == '+' || ch == '-'
                     || ch == '.';
            });
}

// The folder that URIs may not lead out of; see container.h.
std::filesystem::path outermost(const std::filesystem::path& directory) {
  const std::filesystem::path named = directory.lexically_normal();
  if (named.is_absolute()) return (named / "..").lexically_normal();
  std::filesystem::path outer;
  for (const auto& part : named) {
    outer /= part;
    if (part != "..") break;
  }
  return outer;
}

bool lies_in(const std::filesystem::path& path, const std::filesystem::path& folder) {
  const std::filesystem::path way = path.lexically_relative(folder);
  return !way.empty() && *way.begin() != "..";
}

} // namespace

std::vector<std::byte> fetch(const std::string& uri, const Container& container,
                             const std::string& place) {
  const std::string& file = container.name;
  if (lower_case(uri.substr(0, 5)) == "data:") return data_uri(uri, file, place);
  if (has_scheme(uri))
    fail(file, place, "points to '" + uri.substr(0, 80) + "', and nothing is downloaded",
         "Fetch the file and refer to it by a relative path.");
  const std::string decoded = decode_percent(uri);
  const std::filesystem::path relative = std::filesystem::path(decoded).lexically_normal();
  if (decoded.empty() || decoded.find('\0') != std::string::npos || relative.is_absolute())
    fail(file, place, "points to '" + uri.substr(0, 80) + "', outside the scene's directory",
         "Put the file beside the scene and refer to it by a relative path.");
  const std::filesystem::path path = container.directory / relative;
  if (*relative.begin() == "..") {
    if (!lies_in(path.lexically_normal(), outermost(container.directory)))
      fail(file, place,
           "points to '" + uri.substr(0, 80) + "', outside the folders that were named",
           "Open the scene by a path that begins with the folder that holds both, or put the file "
           "beside it.");
    note(file + ": " + place + " leads out of the scene's folder, to "
         + path.lexically_normal().string());
  }
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(path, ignored))
    fail(file, place, "refers to '" + path.string() + "', which does not exist",
         "Put the file there, or use a .glb, which holds everything.");
  return read_file(path);
}

} // namespace gg::scene::gltf
