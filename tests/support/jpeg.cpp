#include "support/jpeg.h"

#include <cstdlib>
#include <cstring>

namespace gg::test {

std::vector<std::byte> jpeg_of(std::vector<std::uint8_t> pixels, const JpegDesc& desc) {
  const int channels = desc.space == JCS_CMYK ? 4 : 3;
  jpeg_compress_struct out{};
  jpeg_error_mgr errors{};
  out.err = jpeg_std_error(&errors);
  jpeg_create_compress(&out);
  unsigned char* data = nullptr;
  unsigned long size = 0;
  jpeg_mem_dest(&out, &data, &size);
  out.image_width = static_cast<JDIMENSION>(desc.width);
  out.image_height = static_cast<JDIMENSION>(desc.height);
  out.input_components = channels;
  out.in_color_space = desc.space;
  jpeg_set_defaults(&out);
  jpeg_set_quality(&out, desc.quality, TRUE);
  if (desc.progressive) jpeg_simple_progression(&out);
  if (!desc.scans.empty()) {
    out.scan_info = desc.scans.data();
    out.num_scans = static_cast<int>(desc.scans.size());
  }
  jpeg_start_compress(&out, TRUE);
  while (out.next_scanline < out.image_height) {
    JSAMPROW row = &pixels[out.next_scanline * static_cast<std::size_t>(desc.width * channels)];
    jpeg_write_scanlines(&out, &row, 1);
  }
  jpeg_finish_compress(&out);
  jpeg_destroy_compress(&out);
  std::vector<std::byte> bytes(size);
  std::memcpy(bytes.data(), data, size);
  std::free(data);
  return bytes;
}

} // namespace gg::test
