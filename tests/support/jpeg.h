// JPEG files for tests to read: the program writes them for display only.
#pragma once

// clang-format off
#include <cstddef>
#include <cstdio>
#include <jpeglib.h> // needs the two above
// clang-format on

#include <cstdint>
#include <vector>

namespace gg::test {

struct JpegDesc {
  int width = 40, height = 30;
  int quality = 95; // 1 to 100
  bool progressive = false;
  J_COLOR_SPACE space = JCS_RGB;
  std::vector<jpeg_scan_info> scans; // instead of the library's own
};

// `pixels`: rows from the top, 3 values a pixel (CMYK: 4).
std::vector<std::byte> jpeg_of(std::vector<std::uint8_t> pixels, const JpegDesc& desc);

} // namespace gg::test
