// KTX2 pictures as KHR_texture_basisu has them (Basis Universal: UASTC, bare or by Zstandard, and ETC1S by BasisLZ), transcoded by
// Khronos' libktx 4. Debian 12 does not package it: it is opened at run time, where there is one.
// Source   KTX File Format Specification, version 2.0 (Khronos 2020), sections 3 and 4.
#include "core/error.h"
#include "core/library.h"
#include "image/formats.h"

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <map>
#include <memory>
#include <mutex>
#include <vector>

namespace gg::image {
namespace formats {
namespace {

struct ktxTexture2; // opaque here

// The part of libktx's interface that is called; the numbers are of its ktx.h.
struct Libktx {
  static constexpr std::uint32_t load_image_data = 1; // KTX_TEXTURE_CREATE_LOAD_IMAGE_DATA_BIT
  static constexpr int rgba32 = 13;                   // KTX_TTF_RGBA32
  static constexpr int success = 0;                   // KTX_SUCCESS

  Library library;
  int (*create)(const std::uint8_t*, std::size_t, std::uint32_t flags, ktxTexture2**) = nullptr;
  int (*transcode)(ktxTexture2*, int format, std::uint32_t flags) = nullptr;
  std::uint8_t* (*data)(ktxTexture2*) = nullptr;
  std::size_t (*data_size)(ktxTexture2*) = nullptr;
  void (*destroy)(ktxTexture2*) = nullptr;
  const char* (*error_text)(int) = nullptr;

  explicit Libktx(const std::vector<std::string>& names) : library(names) {
    library.load(create, "ktxTexture2_CreateFromMemory");
    library.load(transcode, "ktxTexture2_TranscodeBasis");
    library.load(data, "ktxTexture_GetData");
    library.load(data_size, "ktxTexture_GetDataSize");
    library.load(destroy, "ktxTexture2_Destroy");
    library.load(error_text, "ktxErrorString");
  }
  bool complete() const {
    return create && transcode && data && data_size && destroy && error_text;
  }

  // Its tables are made by the first transcoding, which therefore has no other beside it.
  mutable std::mutex first;
  mutable bool has_tables = false;
};

// The library that GROUNDGLASS_LIBKTX names; else the one beside the program, of its installation, or of the system. Null: none.
const Libktx* libktx() {
  static std::mutex mutex;
  static std::map<std::string, std::unique_ptr<Libktx>> opened; // by what the variable says
  const char* const chosen = std::getenv("GROUNDGLASS_LIBKTX");
  const std::lock_guard lock(mutex);
  std::unique_ptr<Libktx>& library = opened[chosen ? chosen : ""];
  if (!library) {
    std::error_code error;
    const std::filesystem::path folder =
        std::filesystem::read_symlink("/proc/self/exe", error).parent_path();
    std::vector<std::string> names{folder / "libktx.so", folder / "../lib/groundglass/libktx.so",
                                   "libktx.so.4"};
    if (chosen && *chosen) names = {chosen};
    library = std::make_unique<Libktx>(names);
  }
  return library->complete() ? library.get() : nullptr;
}

// The head of a file, which says what there is to come: libktx is given nothing that asks for more memory than its pixels take.
constexpr std::size_t index_at = 80;      // after identifier, header and the places of three blocks
constexpr std::size_t level_entry = 24;   // three 64-bit numbers
constexpr std::uint64_t block_bytes = 16; // UASTC, 4 x 4 pixels

template <class T>
T number_at(Bytes bytes, std::size_t at) { // little-endian, as this program's machines are
  T value;
  std::memcpy(&value, bytes.data() + at, sizeof value);
  return value;
}

Size checked_head(Bytes bytes, const std::string& name) {
  const auto refuse = [&](const std::string& what, const std::string& remedy) {
    throw Error(ExitCode::input, name, what, remedy);
  };
  const char* const again = "Download or write the file again.";
  const char* const encode = "Encode it as glTF asks: 2D, Basis Universal (UASTC or ETC1S).";
  if (bytes.size() < index_at) refuse("is truncated: a KTX2 file begins with 80 bytes", again);
  const auto word = [&](std::size_t at) { return number_at<std::uint32_t>(bytes, at); };
  const std::uint32_t format = word(12), width = word(20), height = word(24), depth = word(28),
                      layers = word(32), faces = word(36), scheme = word(44);
  const std::uint32_t levels = std::max(word(40), 1u);
  if (format != 0)
    refuse("holds pixels of VkFormat " + std::to_string(format)
               + ", where glTF has Basis Universal alone",
           encode);
  if (depth != 0 || layers != 0 || faces != 1)
    refuse("is a KTX2 volume, array or cube, where glTF has 2D textures alone", encode);
  constexpr std::uint32_t bare = 0, basis_lz = 1, zstandard = 2;
  if (scheme != bare && scheme != basis_lz && scheme != zstandard)
    refuse("is compressed by scheme " + std::to_string(scheme) + ", which glTF does not have",
           encode);
  check_size(name, width, height);
  constexpr std::uint32_t most_levels = 17; // of max_side
  if (levels > most_levels || bytes.size() < index_at + levels * level_entry)
    refuse("declares " + std::to_string(levels) + " levels, which it does not hold", again);
  for (std::uint32_t level = 0; level < levels; ++level) {
    const std::size_t at = index_at + level * level_entry;
    const auto offset = number_at<std::uint64_t>(bytes, at),
               length = number_at<std::uint64_t>(bytes, at + 8),
               whole = number_at<std::uint64_t>(bytes, at + 16);
    const auto blocks = [&](std::uint32_t side) {
      return (std::max(side >> level, 1u) + std::uint64_t{3}) / 4;
    };
    const std::uint64_t wanted =
        scheme == basis_lz ? 0 : blocks(width) * blocks(height) * block_bytes;
    if (offset > bytes.size() || length > bytes.size() - offset)
      refuse("is truncated: level " + std::to_string(level) + " lies beyond its end", again);
    if (whole != wanted || (scheme == bare && length != wanted))
      refuse("says that level " + std::to_string(level) + " has " + std::to_string(whole)
                 + " bytes, where its size takes " + std::to_string(wanted),
             again);
  }
  return {static_cast<int>(width), static_cast<int>(height)};
}

} // namespace

Size size_of_ktx2(Bytes bytes, const std::string& name) {
  return checked_head(bytes, name);
}

Image8 decode_ktx2(Bytes bytes, const std::string& name) {
  const Size head = checked_head(bytes, name);
  const Libktx* const library = libktx();
  if (!library)
    throw Error(ExitCode::unsupported, name,
                "is a KTX2 picture, which libktx reads; it is not installed", without_libktx);
  const auto refuse = [&](const std::string& why) {
    throw Error(ExitCode::input, name, "is no KTX2 picture that libktx reads: " + why,
                "Download or write the file again.");
  };
  const auto check = [&](int code) {
    if (code != Libktx::success) refuse(library->error_text(code));
  };
  ktxTexture2* made = nullptr;
  check(library->create(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size(),
                        Libktx::load_image_data, &made));
  const std::unique_ptr<ktxTexture2, void (*)(ktxTexture2*)> texture(made, library->destroy);
  {
    std::unique_lock alone(library->first);
    if (library->has_tables) alone.unlock();
    check(library->transcode(texture.get(), Libktx::rgba32, 0));
    if (alone) library->has_tables = true;
  }
  // Levels lie smallest first (§4.4): the whole picture is the last.
  Image8 image{.width = head.width, .height = head.height, .rgba = {}};
  const std::size_t size =
      4 * static_cast<std::size_t>(head.width) * static_cast<std::size_t>(head.height);
  const std::size_t all = library->data_size(texture.get());
  const std::uint8_t* const data = library->data(texture.get());
  if (!data || all < size) refuse("it has fewer pixels than it declares");
  image.rgba.assign(data + all - size, data + all);
  return image;
}

} // namespace formats

bool can_decode_ktx2() {
  return formats::libktx() != nullptr;
}

} // namespace gg::image
