// Damaged picture files: whatever the bytes, a picture or a gg::Error(input) that names the file;
// and pictures that cannot be written leave nothing behind. Under the sanitizers this is the test
// that the readers stay within their memory.
#include "core/error.h"
#include "core/files.h"
#include "image/image.h"
#include "support/errors.h"
#include "support/scratch.h"

#include <gtest/gtest.h>
#include <jpeglib.h>
#include <sys/resource.h>
#include <webp/encode.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <random>

using namespace gg;
using namespace gg::test;

namespace {

using Bytes = std::vector<std::byte>;

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

Bytes jpeg(bool progressive) {
  std::vector<std::uint8_t> pixels = rgb(40, 30);
  jpeg_compress_struct out{};
  jpeg_error_mgr errors{};
  out.err = jpeg_std_error(&errors);
  jpeg_create_compress(&out);
  unsigned char* data = nullptr;
  unsigned long size = 0;
  jpeg_mem_dest(&out, &data, &size);
  out.image_width = 40;
  out.image_height = 30;
  out.input_components = 3;
  out.in_color_space = JCS_RGB;
  jpeg_set_defaults(&out);
  if (progressive) jpeg_simple_progression(&out);
  jpeg_start_compress(&out, TRUE);
  while (out.next_scanline < out.image_height) {
    JSAMPROW row = &pixels[out.next_scanline * std::size_t{120}];
    jpeg_write_scanlines(&out, &row, 1);
  }
  jpeg_finish_compress(&out);
  jpeg_destroy_compress(&out);
  const Bytes bytes = copy(data, size);
  std::free(data);
  return bytes;
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

// Bits flipped, bytes set to what breaks arithmetic, parts cut out, doubled or moved, mostly near
// the start, where headers are.
void damage(Bytes& bytes, std::mt19937& random) {
  const auto below = [&](std::size_t n) { return n == 0 ? 0 : random() % n; };
  const auto place = [&] {
    return random() % 2 == 0 ? below(std::min<std::size_t>(bytes.size(), 400))
                             : below(bytes.size());
  };
  for (auto times = 1 + random() % 4; times > 0 && !bytes.empty(); --times) {
    const std::size_t at = place();
    const std::size_t count = std::min<std::size_t>(1 + below(8), bytes.size() - at);
    const auto begin = bytes.begin() + static_cast<std::ptrdiff_t>(at);
    const auto end = begin + static_cast<std::ptrdiff_t>(count);
    switch (random() % 6) {
    case 0:
      *begin ^= static_cast<std::byte>(1u << random() % 8);
      break;
    case 1:
      std::fill(begin, end, random() % 2 ? std::byte{0xff} : std::byte{0});
      break;
    case 2:
      *begin = std::byte{0x7f};
      break;
    case 3:
      bytes.erase(begin, end);
      break;
    case 4:
      bytes.insert(begin, count, *begin);
      break;
    default:
      std::generate(begin, end, [&] { return static_cast<std::byte>(random()); });
    }
  }
}

// Reads `count` damaged copies; all must end well. Returns how many were refused.
int survive(const Bytes& whole, const char* name, int count) {
  std::mt19937 random(20070625u);
  int refused = 0;
  for (int i = 0; i < count; ++i) {
    Bytes bytes = whole;
    damage(bytes, random);
    const std::filesystem::path path = scratch_file(name, bytes);
    try {
      const image::Image image = image::read(path);
      EXPECT_EQ(image.values.size(), image.index(0, image.height)) << i;
      EXPECT_GE(image.width, 1) << i;
    } catch (const Error& error) {
      ++refused;
      EXPECT_EQ(error.code(), ExitCode::input) << i << ": " << error.what();
      EXPECT_NE(std::string(error.what()).find(name), std::string::npos)
          << i << ": " << error.what();
    }
  }
  return refused;
}

constexpr int copies = 400; // of each format: seconds under the sanitizers, on two busy cores

} // namespace

TEST(damaged_picture, hdr) {
  EXPECT_GT(survive(written(".hdr"), "damaged.hdr", copies), copies / 10);
}

TEST(damaged_picture, exr) {
  EXPECT_GT(survive(written(".exr"), "damaged.exr", copies), copies / 10);
}

TEST(damaged_picture, pfm) {
  EXPECT_GT(survive(written(".pfm"), "damaged.pfm", copies), copies / 100);
}

TEST(damaged_picture, png) {
  EXPECT_GT(survive(written(".png"), "damaged.png", copies), copies / 2);
}

TEST(damaged_picture, jpeg) {
  EXPECT_GT(survive(jpeg(false), "damaged.jpg", copies), copies / 10);
  EXPECT_GT(survive(jpeg(true), "damaged-progressive.jpg", copies), copies / 10);
}

TEST(damaged_picture, webp) {
  EXPECT_GT(survive(webp(false), "damaged.webp", copies), copies / 10);
  EXPECT_GT(survive(webp(true), "damaged-lossless.webp", copies), copies / 10);
}

TEST(damaged_picture, exr_with_checked_headers) {
  // Damage past the header only: the compressed blocks themselves.
  const Bytes whole = written(".exr");
  std::mt19937 random(3u);
  for (int i = 0; i < copies; ++i) {
    Bytes bytes = whole;
    bytes[350 + random() % (bytes.size() - 350)] ^= static_cast<std::byte>(1 + random() % 255);
    const std::filesystem::path path = scratch_file("blocks.exr", bytes);
    try {
      EXPECT_EQ(image::read(path).width, 33);
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ExitCode::input);
    }
  }
}

TEST(unwritable_picture, a_full_disk_leaves_neither_file_nor_temporary) {
  const std::filesystem::path here = scratch_directory();
  // A limit on the size of files fails in write(), as a full disk does.
  rlimit before{};
  ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &before), 0);
  const auto old_handler = std::signal(SIGXFSZ, SIG_IGN);
  const rlimit small{.rlim_cur = 1000, .rlim_max = before.rlim_max};
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &small), 0);
  std::vector<::testing::AssertionResult> results;
  for (const char* name : {"a.exr", "a.hdr", "a.pfm", "a.png"})
    results.push_back(fails_with(ExitCode::output, {name, "cannot be written"},
                                 [&] { image::write(here / name, sample(100, 100)); }));
  ::setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, old_handler);
  for (const auto& result : results)
    EXPECT_TRUE(result);
  EXPECT_TRUE(std::filesystem::is_empty(here));
}
