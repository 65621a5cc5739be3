#include "core/files.h"
#include "image/image.h"
#include "image/samples.h"
#include "support/errors.h"
#include "support/pictures.h"
#include "support/scratch.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace gg;
using namespace gg::test;
using image::Image;

namespace {

const std::string plain = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n";

std::string pixel(int r, int g, int b, int e) {
  return {static_cast<char>(r), static_cast<char>(g), static_cast<char>(b), static_cast<char>(e)};
}

Image read_text(const std::string& bytes) {
  return image::read(scratch_file("picture.hdr", bytes));
}

::testing::AssertionResult is_refused(const std::string& bytes, const std::string& what) {
  return fails_with(ExitCode::input, {"picture.hdr", what}, [&] { read_text(bytes); });
}

} // namespace

TEST(hdr, values_are_mantissa_times_two_to_the_exponent_minus_136) {
  const Image image =
      read_text(plain + "-Y 1 +X 5\n" + pixel(128, 128, 128, 129) + pixel(255, 1, 0, 255)
                + pixel(255, 200, 100, 0) + pixel(200, 3, 7, 1) + pixel(255, 254, 253, 128));
  ASSERT_EQ(image.channels, 3);
  EXPECT_EQ(image.at(0, 0, 0), 1.0f);
  EXPECT_EQ(image.at(1, 0, 0), std::ldexp(255.0f, 119));
  EXPECT_EQ(image.at(1, 0, 1), std::ldexp(1.0f, 119));
  EXPECT_EQ(image.at(2, 0, 0), 0.0f);                   // exponent 0: black
  EXPECT_EQ(image.at(3, 0, 1), std::ldexp(3.0f, -135)); // a denormal float, exact
  EXPECT_EQ(image.at(4, 0, 2), 253.0f / 256.0f);
}

TEST(hdr, flat_older_and_newer_encodings_read_alike) {
  const std::string a = pixel(10, 20, 30, 128), b = pixel(40, 50, 60, 127);
  std::string flat, newer = {2, 2, 1, 44};
  for (int x = 0; x < 300; ++x)
    flat += x < 299 ? a : b;
  // 298 repeats of the first pixel: 42 and 1 * 256.
  const std::string older = a + pixel(1, 1, 1, 42) + pixel(1, 1, 1, 1) + b;
  for (const auto& [first, last] : {std::pair{10, 40}, {20, 50}, {30, 60}, {128, 127}}) {
    for (const int run : {127, 127, 45})
      newer += {static_cast<char>(128 + run), static_cast<char>(first)};
    newer += {1, static_cast<char>(last)};
  }
  const Image expected = read_text(plain + "-Y 1 +X 300\n" + flat);
  EXPECT_EQ(expected.at(298, 0, 2), 30.0f / 256.0f);
  EXPECT_EQ(expected.at(299, 0, 2), 60.0f / 512.0f);
  EXPECT_TRUE(pictures_agree(read_text(plain + "-Y 1 +X 300\n" + older), expected, {}, "older"));
  EXPECT_TRUE(pictures_agree(read_text(plain + "-Y 1 +X 300\n" + newer), expected, {}, "newer"));
}

TEST(hdr, all_eight_orientations_put_the_pixels_upright) {
  // A picture of two rows and three columns whose red counts 1..6 in reading order, stored in the
  // order that each resolution line announces.
  const auto stored = [](const char* order) {
    std::string bytes;
    for (const char* c = order; *c; ++c)
      bytes += pixel(*c - '0', 0, 0, 136);
    return bytes;
  };
  for (const auto& [resolution, order] : {std::pair{"-Y 2 +X 3", "123456"},
                                          {"-Y 2 -X 3", "321654"},
                                          {"+Y 2 +X 3", "456123"},
                                          {"+Y 2 -X 3", "654321"},
                                          {"+X 3 -Y 2", "142536"},
                                          {"+X 3 +Y 2", "415263"},
                                          {"-X 3 -Y 2", "362514"},
                                          {"-X 3 +Y 2", "635241"}}) {
    const Image image = read_text(plain + resolution + "\n" + stored(order));
    ASSERT_EQ(image.width, 3) << resolution;
    ASSERT_EQ(image.height, 2) << resolution;
    for (int i = 0; i < 6; ++i)
      EXPECT_EQ(image.at(i % 3, i / 3), static_cast<float>(i + 1)) << resolution;
  }
}

TEST(hdr, header_lines_that_change_values_are_undone) {
  const std::string body = "-Y 1 +X 1\n" + pixel(128, 64, 32, 131);
  const Image image = read_text("#?RGBE\n# a comment\nEXPOSURE=2\nVIEW= -vtv\r\nEXPOSURE= 2.0\n"
                                "COLORCORR= 1 0.5 2\nFORMAT=32-bit_rle_rgbe\nSOFTWARE=x\n\n"
                                + body);
  EXPECT_EQ(image.at(0, 0, 0), 1.0f);
  EXPECT_EQ(image.at(0, 0, 1), 1.0f);
  EXPECT_EQ(image.at(0, 0, 2), 0.125f);
  // Without FORMAT, and with GAMMA and PRIMARIES as Photoshop writes them.
  EXPECT_EQ(read_text("#?RADIANCE\nGAMMA=1\nPRIMARIES=0 0 0 0 0 0 0 0\n\n" + body).at(0, 0), 4.0f);
}

TEST(hdr, malformed_headers_are_refused_by_name) {
  const std::string size = "-Y 1 +X 1\n", body = pixel(1, 2, 3, 128);
  EXPECT_TRUE(is_refused("", "is empty"));
  EXPECT_TRUE(is_refused("P6 1 1 255\n", "not a picture in a known format"));
  EXPECT_TRUE(is_refused("#?RADIANCE\nFORMAT=32-bit_rle_xyze\n\n" + size + body, "XYZ"));
  EXPECT_TRUE(is_refused("#?RADIANCE\nFORMAT=8-bit\n\n" + size + body, "FORMAT \"8-bit\""));
  for (const char* bad : {"x", "0", "-1", "nan", "inf", "1e-320", "1e999", ""})
    EXPECT_TRUE(
        is_refused("#?RADIANCE\nEXPOSURE=" + std::string(bad) + "\n\n" + size + body, "EXPOSURE"))
        << bad;
  for (const char* bad : {"-Y 1", "1 1", "-Y 1 +Y 1", "-Y one +X 1", "-Y 1 +X 1 0", "-Y -1 -X +1",
                          "", "-Y1 +X1", "-Y 99999999999999999999 +X 1"})
    EXPECT_TRUE(is_refused(plain + bad + "\n" + body, "should give the size")) << bad;
  EXPECT_TRUE(is_refused(plain + "-Y 0 +X 1\n" + body, "1 x 0 pixels"));
  EXPECT_TRUE(is_refused(plain + "-Y 70000 +X 1\n" + body, "more than are accepted"));
  EXPECT_TRUE(is_refused(plain + "-Y 65000 +X 65000\n" + body, "more than are accepted"));
  EXPECT_TRUE(is_refused(plain + "-Y 8000 +X 16000\n" + body, "ends too soon"));
  EXPECT_TRUE(is_refused("#?RADIANCE\n" + std::string(1 << 17, 'x'), "no end of its header"));
}

TEST(hdr, malformed_pixels_are_refused_with_byte_and_scan_line) {
  const std::string size = "-Y 2 +X 8\n", start = {2, 2, 0, 8}, pad(64, '\x08');
  EXPECT_TRUE(is_refused(plain + size + std::string{2, 2, 0, 9} + pad, "scan line of 9 pixels"));
  EXPECT_TRUE(is_refused(plain + size + start + "\x89\x01" + pad, "does not fit its scan line"));
  EXPECT_TRUE(is_refused(plain + size + start + "\x09" + pad, "does not fit its scan line"));
  EXPECT_TRUE(is_refused(plain + size + start + std::string(1, '\0') + pad, "does not fit"));
  EXPECT_TRUE(is_refused(plain + "-Y 1 +X 2\n" + pixel(1, 1, 1, 1) + pad, "does not fit"));
  EXPECT_TRUE(
      is_refused(plain + "-Y 1 +X 2\n" + pixel(1, 2, 3, 4) + pixel(1, 1, 1, 2), "does not fit"));
  std::string digits = plain + "-Y 1 +X 2\n" + pixel(1, 2, 3, 4);
  for (int i = 0; i < 5; ++i)
    digits += pixel(1, 1, 1, 0);
  EXPECT_TRUE(is_refused(digits, "does not fit"));
  EXPECT_TRUE(is_refused(plain + size + start + std::string(8, '\x88') + start, "(scan line 1)"));
  EXPECT_TRUE(is_refused(plain + size + start + "\x89\x01" + pad, "byte 50"));
}

TEST(hdr, truncation_anywhere_is_refused) {
  const std::filesystem::path path = scratch_directory() / "whole.hdr";
  image::write(path, noise(40, 5, 3));
  const std::vector<std::byte> whole = read_file(path);
  for (std::size_t size = 0; size < whole.size(); ++size) {
    const auto part = scratch_file("part.hdr", std::span(whole).first(size));
    ASSERT_TRUE(fails_with(ExitCode::input, {"part.hdr"}, [&] { image::read(part); })) << size;
  }
}

TEST(hdr, what_is_written_is_read_back_within_half_a_step) {
  // Widths below and above the newer encoding's range are written flat.
  for (const int width : {1, 7, 8, 129, 500, 32768}) {
    const Image image = noise(width, 3, 3);
    const std::filesystem::path path = scratch_directory() / "picture.hdr";
    image::write(path, image);
    const Image back = image::read(path);
    ASSERT_EQ(back.width, width);
    for (int y = 0; y < 3; ++y)
      for (int x = 0; x < width; ++x) {
        const float brightest = std::max({image.at(x, y, 0), image.at(x, y, 1), image.at(x, y, 2)});
        // The brightest channel becomes 128 to 255 steps, so half a step is at most 1/256 of it;
        // or 255.5 steps and more become 128 steps twice as long.
        for (int c = 0; c < 3; ++c)
          ASSERT_LE(std::abs(back.at(x, y, c) - image.at(x, y, c)), brightest / 255.5f);
      }
  }
}

TEST(hdr, values_on_its_grid_survive_exactly) {
  Image image(64, 2, 3);
  for (int i = 0; i < 128; ++i) {
    const int exponent = i * 2 - 128;
    for (int c = 0; c < 3; ++c)
      image.values[static_cast<std::size_t>(i * 3 + c)] =
          std::ldexp(static_cast<float>(c == i % 3 ? 128 + i % 128 : i % 100), exponent - 8);
  }
  const std::filesystem::path path = scratch_directory() / "picture.hdr";
  image::write(path, image);
  // 2^-128 is one of the exponents that RGBE reads as black.
  for (int c = 0; c < 3; ++c)
    image.at(0, 0, c) = 0.0f;
  EXPECT_TRUE(pictures_agree(image::read(path), image, {}));
}

TEST(hdr, values_that_it_cannot_hold_have_a_defined_end) {
  Image image(3, 1, 3);
  image.values = {-1.0f, 2.0f, 0.0f, 1e-42f, 0.0f, 0.0f, INFINITY, 1.0f, 0.0f};
  const std::filesystem::path path = scratch_directory() / "picture.hdr";
  image::write(path, image);
  const Image back = image::read(path);
  EXPECT_EQ(back.at(0, 0, 0), 0.0f);
  EXPECT_EQ(back.at(0, 0, 1), 2.0f);
  EXPECT_EQ(back.at(1, 0, 0), 0.0f);
  EXPECT_EQ(back.at(2, 0, 0), std::ldexp(255.0f, 119));
  image.values[4] = NAN;
  EXPECT_TRUE(fails_with(ExitCode::output, {"picture.hdr", "(1, 0)", "not a number"},
                         [&] { image::write(path, image); }));
  EXPECT_EQ(image::read(path).at(0, 0, 1), 2.0f) << "the file that was there is kept";
}
