#include "core/files.h"
#include "image/image.h"
#include "image/samples.h"
#include "support/errors.h"
#include "support/pictures.h"
#include "support/scratch.h"

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfOutputFile.h>
#include <OpenEXR/ImfTiledOutputFile.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

using namespace gg;
using namespace gg::test;
using image::Exr;
using image::Image;

namespace {

Exr planes(int width, int height, const std::vector<std::string>& names) {
  Exr exr{.width = width, .height = height, .channels = {}, .attributes = {}};
  const Image values = noise(width, height, 1);
  for (std::size_t i = 0; i < names.size(); ++i) {
    exr.channels[names[i]] = values.values;
    for (float& v : exr.channels[names[i]])
      v += static_cast<float>(i);
  }
  return exr;
}

// As other programs write: a window away from the origin, tiles, unsigned integers.
void write_tiled(const std::filesystem::path& path, const Image& image) {
  const Imath::Box2i window({10, 20}, {9 + image.width, 19 + image.height});
  Imf::Header header(window, window);
  header.setTileDescription(Imf::TileDescription(16, 8));
  header.compression() = Imf::PIZ_COMPRESSION;
  std::vector<std::uint32_t> id(image.values.size() / 3);
  for (std::size_t i = 0; i < id.size(); ++i)
    id[i] = static_cast<std::uint32_t>(i);
  Imf::FrameBuffer frame;
  for (int c = 0; c < 3; ++c) {
    header.channels().insert(std::string(1, "RGB"[c]), Imf::Channel(Imf::FLOAT));
    frame.insert(std::string(1, "RGB"[c]),
                 Imf::Slice::Make(Imf::FLOAT, &image.values[static_cast<std::size_t>(c)],
                                  header.dataWindow(), 12,
                                  12 * static_cast<std::size_t>(image.width)));
  }
  header.channels().insert("id", Imf::Channel(Imf::UINT));
  frame.insert("id", Imf::Slice::Make(Imf::UINT, id.data(), header.dataWindow(), 4,
                                      4 * static_cast<std::size_t>(image.width)));
  Imf::TiledOutputFile file(path.c_str(), header, 0);
  file.setFrameBuffer(frame);
  file.writeTiles(0, file.numXTiles() - 1, 0, file.numYTiles() - 1);
}

} // namespace

TEST(exr, float_pictures_round_trip_to_the_bit) {
  for (const int channels : {1, 3, 4}) {
    Image image = noise(31, 17, channels);
    image.values[1] = INFINITY;
    image.values[2] = std::numeric_limits<float>::denorm_min();
    const std::filesystem::path path = scratch_directory() / "picture.exr";
    image::write(path, image);
    const Image back = image::read(path);
    ASSERT_EQ(back.channels, channels == 1 ? 3 : channels);
    for (int y = 0; y < 17; ++y)
      for (int x = 0; x < 31; ++x)
        for (int c = 0; c < back.channels; ++c)
          ASSERT_EQ(back.at(x, y, c), image.at(x, y, channels == 1 ? 0 : c));
  }
}

TEST(exr, every_channel_and_attribute_comes_back) {
  Exr exr = planes(9, 5, {"R", "G", "B", "stderr.R", "stderr.G", "stderr.B", "id"});
  exr.attributes = {{"spp", "1024"}, {"command", "truth ball.glb -o x.exr"}};
  const std::filesystem::path path = scratch_directory() / "truth.exr";
  image::write_exr(path, exr);
  const Exr back = image::read_exr(path);
  EXPECT_EQ(back.channels, exr.channels);
  EXPECT_EQ(back.attributes.at("spp"), "1024");
  EXPECT_EQ(back.attributes.at("command"), "truth ball.glb -o x.exr");
  EXPECT_FALSE(back.half);
}

TEST(exr, half_files_round_to_eleven_bits_and_keep_ids) {
  Exr exr = planes(8, 4, {"R", "G", "B", "id"});
  for (float& v : exr.channels["id"])
    v = 70001.0f; // neither an integer nor in range as a half
  exr.half = true;
  const std::filesystem::path path = scratch_directory() / "half.exr";
  image::write_exr(path, exr);
  const Exr back = image::read_exr(path);
  EXPECT_TRUE(back.half);
  EXPECT_EQ(back.channels.at("id"), exr.channels.at("id"));
  constexpr float half_step = 1.0f / 2048.0f, smallest_half_step = 0x1p-25f;
  for (std::size_t i = 0; i < 32; ++i) {
    const float v = exr.channels["G"][i];
    EXPECT_NEAR(back.channels.at("G")[i], v, std::abs(v) * half_step + smallest_half_step);
  }
}

TEST(exr, tiles_offset_windows_and_integer_channels_are_read) {
  const Image image = noise(37, 23, 3);
  const std::filesystem::path path = scratch_directory() / "tiled.exr";
  write_tiled(path, image);
  EXPECT_TRUE(pictures_agree(image::read(path), image, {}));
  EXPECT_EQ(image::read_exr(path).channels.at("id")[40], 40.0f);
}

TEST(exr, the_display_window_is_the_picture) {
  const std::filesystem::path path = scratch_directory() / "windows.exr";
  const Image image = noise(8, 6, 1);
  const auto read_shown = [&](const Imath::Box2i& display) {
    const Imath::Box2i data({10, 20}, {17, 25});
    Imf::Header header(display, data);
    header.channels().insert("Y", Imf::Channel(Imf::FLOAT));
    Imf::FrameBuffer frame;
    frame.insert("Y", Imf::Slice::Make(Imf::FLOAT, image.values.data(), data, 4, 32));
    {
      Imf::OutputFile file(path.c_str(), header, 0);
      file.setFrameBuffer(frame);
      file.writePixels(6);
    }
    return image::read(path);
  };
  const Image padded = read_shown({{8, 19}, {19, 26}}), cropped = read_shown({{11, 22}, {14, 24}});
  ASSERT_EQ(padded.width, 12);
  ASSERT_EQ(padded.height, 8);
  ASSERT_EQ(cropped.width, 4);
  ASSERT_EQ(cropped.height, 3);
  for (int y = 0; y < 8; ++y)
    for (int x = 0; x < 12; ++x) {
      const bool inside = x >= 2 && x < 10 && y >= 1 && y < 7;
      EXPECT_EQ(padded.at(x, y), inside ? image.at(x - 2, y - 1) : 0.0f) << x << ' ' << y;
    }
  for (int y = 0; y < 3; ++y)
    for (int x = 0; x < 4; ++x)
      EXPECT_EQ(cropped.at(x, y), image.at(x + 1, y + 2)) << x << ' ' << y;
  // Elsewhere, or so large that next to nothing of it is there: the data window.
  EXPECT_EQ(read_shown({{100, 100}, {107, 103}}).width, 8);
  EXPECT_EQ(read_shown({{0, 0}, {9999, 9999}}).width, 8);
}

TEST(exr, colour_is_found_in_the_only_layer_and_in_grey) {
  const std::filesystem::path path = scratch_directory() / "layers.exr";
  image::write_exr(path,
                   planes(4, 3, {"View.Combined.R", "View.Combined.G", "View.Combined.B", "Z"}));
  EXPECT_EQ(image::read(path).channels, 3);
  EXPECT_EQ(image::read(path).at(0, 0, 1), noise(4, 3, 1).at(0, 0) + 1.0f);
  image::write_exr(path, planes(4, 3, {"Y"}));
  EXPECT_EQ(image::read(path).at(2, 1, 2), noise(4, 3, 1).at(2, 1));
}

TEST(exr, missing_and_doubtful_channels_are_refused_by_name) {
  const std::filesystem::path path = scratch_directory() / "odd.exr";
  image::write_exr(path, planes(4, 3, {"R", "B"}));
  EXPECT_TRUE(fails_with(ExitCode::input, {"odd.exr", "B, R", "channels R, G and B"},
                         [&] { image::read(path); }));
  image::write_exr(path, planes(4, 3, {"a.R", "a.G", "a.B", "b.R", "b.G", "b.B"}));
  EXPECT_TRUE(fails_with(ExitCode::input, {"odd.exr", "several layers", "a.R", "b.R"},
                         [&] { image::read(path); }));
  EXPECT_TRUE(fails_with(ExitCode::input, {"a.hdr", "not an OpenEXR"},
                         [&] { image::read_exr(scratch_file("a.hdr", "#?RADIANCE\n")); }));
}

TEST(exr, subsampled_channels_are_refused) {
  const std::filesystem::path path = scratch_directory() / "chroma.exr";
  {
    Imf::Header header(4, 4);
    header.channels().insert("Y", Imf::Channel(Imf::FLOAT));
    header.channels().insert("RY", Imf::Channel(Imf::FLOAT, 2, 2));
    const std::vector<float> values(16);
    Imf::FrameBuffer frame;
    char* const base = reinterpret_cast<char*>(const_cast<float*>(values.data()));
    frame.insert("Y", Imf::Slice(Imf::FLOAT, base, 4, 16));
    frame.insert("RY", Imf::Slice(Imf::FLOAT, base, 4, 8, 2, 2));
    Imf::OutputFile file(path.c_str(), header, 0);
    file.setFrameBuffer(frame);
    file.writePixels(4);
  }
  EXPECT_TRUE(fails_with(ExitCode::input, {"chroma.exr, channel RY", "Save it with R, G and B"},
                         [&] { image::read(path); }));
}

TEST(exr, truncation_anywhere_is_refused) {
  const std::filesystem::path path = scratch_directory() / "whole.exr";
  image::write(path, noise(21, 40, 3)); // three blocks of scan lines
  const std::vector<std::byte> whole = read_file(path);
  for (std::size_t size = 0; size < whole.size(); size += size < 700 ? 1 : 61) {
    const auto part = scratch_file("part.exr", std::span(whole).first(size));
    ASSERT_TRUE(fails_with(ExitCode::input, {"part.exr"}, [&] { image::read(part); })) << size;
  }
}

TEST(exr, a_huge_declared_picture_is_refused) {
  const std::filesystem::path path = scratch_directory() / "small.exr";
  image::write(path, noise(4, 4, 3));
  std::vector<std::byte> bytes = read_file(path);
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  // dataWindow: name, type "box2i", a length, then xMin, yMin, xMax, yMax.
  const std::size_t window = text.find("dataWindow") + 11 + 6 + 4;
  bytes.resize(bytes.size()
               + 65536); // room for the table of scan lines, which the library wants first
  const auto declare = [&](int width, int height) {
    for (const auto& [value, at] : {std::pair{width - 1, window + 8}, {height - 1, window + 12}})
      for (std::size_t i = 0; i < 4; ++i)
        bytes[at + i] = static_cast<std::byte>(value >> (8 * i) & 255);
    return scratch_file("huge.exr", bytes);
  };
  EXPECT_EQ(image::read(declare(4, 4)).width, 4);
  for (const auto& [width, height, what] : {std::tuple{16384, 8192, "bytes cannot hold"},
                                            {16384, 16384, "more than are accepted"},
                                            {65536, 65536, "more than are accepted"},
                                            {100000, 1, "huge.exr"},
                                            {0x7fffffff, 0x7fffffff, "huge.exr"}})
    EXPECT_TRUE(fails_with(ExitCode::input, {what}, [&] { image::read(declare(width, height)); }))
        << width << " x " << height;
}
