#include "core/files.h"
#include "image/image.h"
#include "image/samples.h"
#include "support/errors.h"
#include "support/jpeg.h"
#include "support/scratch.h"

#include <gtest/gtest.h>
#include <webp/encode.h>

#include <cstdio>
#include <cstdlib>
#include <cstring>

using namespace gg;
using namespace gg::test;
using image::Image8;

namespace {

using Bytes = std::vector<std::byte>;

Bytes copy(const void* data, std::size_t size) {
  Bytes bytes(size);
  std::memcpy(bytes.data(), data, size);
  return bytes;
}

// Red to the right, green downwards: a transposed or mirrored picture shows.
std::vector<std::uint8_t> ramps(int width, int height, int channels) {
  std::vector<std::uint8_t> pixels;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      for (int c = 0; c < channels; ++c)
        pixels.push_back(static_cast<std::uint8_t>(c == 0   ? 255 * x / (width - 1)
                                                   : c == 1 ? 255 * y / (height - 1)
                                                   : c == 2 ? 64
                                                            : 200));
  return pixels;
}

Bytes jpeg(int width, int height, bool progressive, J_COLOR_SPACE space = JCS_RGB,
           const std::vector<jpeg_scan_info>& scans = {}) {
  return jpeg_of(ramps(width, height, space == JCS_CMYK ? 4 : 3), {.width = width,
                                                                   .height = height,
                                                                   .progressive = progressive,
                                                                   .space = space,
                                                                   .scans = scans});
}

Bytes webp(int width, int height, bool lossless) {
  const std::vector<std::uint8_t> pixels = ramps(width, height, 4);
  std::uint8_t* data = nullptr;
  const std::size_t size =
      lossless ? WebPEncodeLosslessRGBA(pixels.data(), width, height, width * 4, &data)
               : WebPEncodeRGBA(pixels.data(), width, height, width * 4, 95.0f, &data);
  const Bytes bytes = copy(data, size);
  WebPFree(data);
  return bytes;
}

Bytes png(int width, int height, int channels) {
  const std::filesystem::path path = scratch_directory() / "sample.png";
  image::write(path, steps(width, height, channels));
  return read_file(path);
}

Image8 decode(const Bytes& bytes) {
  return image::decode(bytes.data(), bytes.size(), "texture 3");
}

::testing::AssertionResult is_refused(const Bytes& bytes, const std::string& what) {
  return fails_with(ExitCode::input, {"texture 3", what}, [&] { decode(bytes); });
}

void put(Bytes& bytes, std::size_t at, std::initializer_list<int> values) {
  for (const int value : values)
    bytes[at++] = static_cast<std::byte>(value);
}

} // namespace

TEST(decode, jpeg_and_webp_come_out_upright) {
  // Quality 95 on smooth ramps: measured 5 of 255 at worst.
  constexpr int lossy = 8;
  for (const auto& [bytes, tolerance] : {std::pair{jpeg(50, 40, false), lossy},
                                         {jpeg(50, 40, true), lossy},
                                         {webp(50, 40, false), lossy},
                                         {webp(50, 40, true), 0}}) {
    const Image8 image = decode(bytes);
    ASSERT_EQ(image.width, 50);
    ASSERT_EQ(image.height, 40);
    const std::vector<std::uint8_t> expected = ramps(50, 40, 4);
    for (std::size_t i = 0; i < expected.size(); ++i) {
      if (i % 4 == 3) continue;
      ASSERT_NEAR(image.rgba[i], expected[i], tolerance) << i;
    }
  }
  EXPECT_EQ(decode(webp(50, 40, true)).rgba[3], 200);
  EXPECT_EQ(decode(jpeg(50, 40, false)).rgba[3], 255);
}

TEST(decode, truncation_anywhere_is_refused) {
  for (const Bytes& whole : {png(40, 30, 3), jpeg(40, 30, false), jpeg(40, 30, true),
                             webp(40, 30, false), webp(40, 30, true)}) {
    EXPECT_NO_THROW(decode(whole));
    // Without its two bytes of end marker a JPEG of one scan still has all its rows.
    const bool one_scan = whole == jpeg(40, 30, false);
    for (std::size_t size = 0; size < whole.size() - (one_scan ? 2 : 0); ++size)
      ASSERT_TRUE(is_refused(Bytes(whole.begin(), whole.begin() + static_cast<long>(size)), ""))
          << size << " of " << whole.size();
  }
}

TEST(decode, a_jpeg_without_its_end_marker_is_the_same_picture) {
  const Bytes whole = jpeg(40, 30, false);
  for (const std::size_t lost : {1u, 2u})
    EXPECT_EQ(decode(Bytes(whole.begin(), whole.end() - static_cast<long>(lost))).rgba,
              decode(whole).rgba);
}

TEST(decode, other_formats_are_refused_by_name) {
  EXPECT_TRUE(is_refused({}, "is empty"));
  EXPECT_TRUE(is_refused(copy("GIF89a", 6), "not a PNG, JPEG or WebP"));
  EXPECT_TRUE(is_refused(copy("#?RADIANCE\n", 11), "not a PNG, JPEG or WebP"));
  EXPECT_TRUE(is_refused(jpeg(8, 8, false, JCS_CMYK), "CMYK"));
}

TEST(decode, a_png_with_a_wrong_checksum_is_refused) {
  Bytes bytes = png(40, 30, 3);
  bytes[bytes.size() - 20] ^= std::byte{1};
  EXPECT_TRUE(is_refused(bytes, "byte"));
}

TEST(decode, declared_sizes_are_checked_before_memory_is_taken) {
  // IHDR of a PNG: 8 bytes of signature, length, name, then width and height; its checksum, worked
  // out for these two sizes, follows at 29.
  Bytes tall = png(40, 30, 3);
  put(tall, 16, {0, 0, 0x40, 0, 0, 0, 0x20, 0}); // 16384 x 8192, the most that is accepted
  const auto checksum = [](const Bytes& bytes) {
    std::uint32_t crc = ~0u;
    for (std::size_t i = 12; i < 29; ++i) {
      crc ^= std::to_integer<std::uint32_t>(bytes[i]);
      for (int bit = 0; bit < 8; ++bit)
        crc = crc & 1u ? 0xedb88320u ^ (crc >> 1) : crc >> 1;
    }
    return ~crc;
  };
  const auto sign = [&](Bytes& bytes) {
    const std::uint32_t crc = checksum(bytes);
    put(bytes, 29,
        {static_cast<int>(crc >> 24), static_cast<int>(crc >> 16 & 255),
         static_cast<int>(crc >> 8 & 255), static_cast<int>(crc & 255)});
  };
  sign(tall);
  EXPECT_TRUE(is_refused(tall, "cannot hold"));
  put(tall, 16, {0, 0, 0x80, 0, 0, 0, 0x80, 0});
  sign(tall);
  EXPECT_TRUE(is_refused(tall, "more than are accepted"));
  put(tall, 16, {0x7f, 0xff, 0xff, 0xff, 0, 0, 0, 1});
  sign(tall);
  EXPECT_TRUE(is_refused(tall, "malformed"));

  // SOF0 of a JPEG: marker, length, precision, height, width.
  Bytes wide = jpeg(40, 30, false);
  std::size_t frame = 0;
  while (wide[frame] != std::byte{0xff} || wide[frame + 1] != std::byte{0xc0})
    ++frame;
  put(wide, frame + 5, {0xff, 0xdc, 0xff, 0xdc}); // 65500, the library's own limit
  EXPECT_TRUE(is_refused(wide, "more than are accepted"));
}

TEST(decode, a_jpeg_of_many_scans_is_refused) {
  // Every coefficient a scan of its own: legal, and 190 times the work.
  std::vector<jpeg_scan_info> scans{
      {.comps_in_scan = 3, .component_index = {0, 1, 2}, .Ss = 0, .Se = 0, .Ah = 0, .Al = 0}};
  for (int component = 0; component < 3; ++component)
    for (int k = 1; k < 64; ++k)
      scans.push_back(
          {.comps_in_scan = 1, .component_index = {component}, .Ss = k, .Se = k, .Ah = 0, .Al = 0});
  EXPECT_TRUE(is_refused(jpeg(64, 64, true, JCS_RGB, scans), "more than 100 scans"));
  // Up to the limit it is an ordinary picture.
  scans.resize(64);
  EXPECT_EQ(decode(jpeg(64, 64, true, JCS_RGB, scans)).width, 64);
}
