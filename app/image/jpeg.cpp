// JPEG by libjpeg-turbo. It goes on after damage with a warning and grey blocks; here those
// warnings are errors.
#include "core/error.h"
#include "image/formats.h"

#include <jerror.h>
#include <jpeglib.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <csetjmp>
#include <cstdio>
#include <cstdlib>

namespace gg::image::formats {
namespace {

// A progressive JPEG can hold any number of scans over the whole picture, each a few bytes: a small
// file that takes hours. Encoders write about ten.
constexpr int max_scans = 100;

// As in png.cpp: what must outlive a longjmp lives in the caller's frame.
struct Reader {
  jpeg_decompress_struct jpeg{};
  jpeg_error_mgr errors{};
  jpeg_progress_mgr progress{};
  std::jmp_buf out{};
  Bytes in;
  std::string message;
  bool one_scan = false; // whose last row is the end of the data
  bool unended = false;  // the data end without an end marker

  ~Reader() { jpeg_destroy_decompress(&jpeg); }

  bool read_header() {
    if (setjmp(out)) return false;
    jpeg_create_decompress(&jpeg);
    jpeg.client_data = this;
    jpeg.progress = &progress;
    jpeg_mem_src(&jpeg, reinterpret_cast<const unsigned char*>(in.data()), in.size());
    jpeg_read_header(&jpeg, TRUE);
    return true;
  }

  bool read_pixels(std::uint8_t* rgba) {
    if (setjmp(out)) return false;
    one_scan = !jpeg_has_multiple_scans(&jpeg);
    jpeg.out_color_space = JCS_EXT_RGBA;
    jpeg_start_decompress(&jpeg);
    const std::size_t pitch = std::size_t{4} * jpeg.output_width;
    while (jpeg.output_scanline < jpeg.output_height) {
      JSAMPROW row = rgba + jpeg.output_scanline * pitch;
      jpeg_read_scanlines(&jpeg, &row, 1);
    }
    jpeg_finish_decompress(&jpeg);
    return true;
  }
};

void on_error(j_common_ptr common) {
  Reader& reader = *static_cast<Reader*>(common->client_data);
  std::array<char, JMSG_LENGTH_MAX> text{};
  common->err->format_message(common, text.data());
  reader.message = text.data();
  std::longjmp(reader.out, 1);
}

void on_message(j_common_ptr common, int level) {
  Reader& reader = *static_cast<Reader*>(common->client_data);
  // If the data end too soon for the rows, JWRN_HIT_MARKER follows. Of several scans the last ones may be missing altogether.
  if (reader.one_scan && common->err->msg_code == JWRN_JPEG_EOF) {
    reader.unended = true;
    return;
  }
  // Bytes between segments harm nothing.
  if (level < 0 && common->err->msg_code != JWRN_EXTRANEOUS_DATA) on_error(common);
}

void on_progress(j_common_ptr common) {
  const auto* const jpeg = reinterpret_cast<jpeg_decompress_struct*>(common);
  if (jpeg->input_scan_number <= max_scans) return;
  Reader& reader = *static_cast<Reader*>(common->client_data);
  reader.message = "more than " + std::to_string(max_scans) + " scans";
  std::longjmp(reader.out, 1);
}

[[noreturn]] void fail(const Reader& reader, const std::string& name) {
  const std::size_t left = reader.jpeg.src ? reader.jpeg.src->bytes_in_buffer : 0;
  const std::size_t at = left <= reader.in.size() ? reader.in.size() - left : 0;
  throw Error(ExitCode::input, name + ", byte " + std::to_string(at),
              "is truncated or malformed: " + reader.message, "Download or write the file again.");
}

// libjpeg allocates `bytes` by malloc.
struct Writer {
  jpeg_compress_struct jpeg{};
  jpeg_error_mgr errors{};
  std::jmp_buf out{};
  unsigned char* bytes = nullptr;
  unsigned long size = 0;
  std::string message;

  ~Writer() {
    jpeg_destroy_compress(&jpeg);
    std::free(bytes);
  }

  bool begin(int width, int height, int channels) {
    if (setjmp(out)) return false;
    constexpr int quality = 95; // errors of about 1 of 255
    jpeg_create_compress(&jpeg);
    jpeg.client_data = this;
    jpeg_mem_dest(&jpeg, &bytes, &size);
    jpeg.image_width = static_cast<JDIMENSION>(width);
    jpeg.image_height = static_cast<JDIMENSION>(height);
    jpeg.input_components = channels;
    jpeg.in_color_space = channels == 1 ? JCS_GRAYSCALE : JCS_RGB;
    jpeg_set_defaults(&jpeg);
    jpeg_set_quality(&jpeg, quality, TRUE);
    for (int c = 0; c < jpeg.num_components; ++c) // no chroma subsampling
      jpeg.comp_info[c].h_samp_factor = jpeg.comp_info[c].v_samp_factor = 1;
    jpeg_start_compress(&jpeg, TRUE);
    return true;
  }
  bool write(std::uint8_t* row) {
    if (setjmp(out)) return false;
    JSAMPROW rows[] = {row};
    jpeg_write_scanlines(&jpeg, rows, 1);
    return true;
  }
  bool finish() {
    if (setjmp(out)) return false;
    jpeg_finish_compress(&jpeg);
    return true;
  }
};

void on_write_error(j_common_ptr common) {
  Writer& writer = *static_cast<Writer*>(common->client_data);
  std::array<char, JMSG_LENGTH_MAX> text{};
  common->err->format_message(common, text.data());
  writer.message = text.data();
  std::longjmp(writer.out, 1);
}

} // namespace

namespace {

// Reads the header.
Size open(Reader& reader, Bytes bytes, const std::string& name) {
  reader.in = bytes;
  reader.jpeg.err = jpeg_std_error(&reader.errors);
  reader.jpeg.client_data = &reader;
  reader.errors.error_exit = on_error;
  reader.errors.emit_message = on_message;
  reader.progress.progress_monitor = on_progress;
  if (!reader.read_header()) fail(reader, name);
  check_size(name, reader.jpeg.image_width, reader.jpeg.image_height);
  if (reader.jpeg.jpeg_color_space == JCS_CMYK || reader.jpeg.jpeg_color_space == JCS_YCCK)
    throw Error(ExitCode::input, name, "holds printing inks (CMYK)", "Save it as an RGB picture.");
  return {static_cast<int>(reader.jpeg.image_width), static_cast<int>(reader.jpeg.image_height)};
}

} // namespace

Size size_of_jpeg(Bytes bytes, const std::string& name) {
  Reader reader;
  return open(reader, bytes, name);
}

Image8 decode_jpeg(Bytes bytes, const std::string& name) {
  Reader reader;
  const Size size = open(reader, bytes, name);
  Image8 image{.width = size.width, .height = size.height, .rgba = {}};
  image.rgba.resize(4 * static_cast<std::size_t>(size.pixels()));
  if (!reader.read_pixels(image.rgba.data())) fail(reader, name);
  if (reader.unended) note(name + ": has no end marker after its last row; read all the same");
  return image;
}

std::vector<std::byte> encode_jpeg(const Image& image, const std::string& name) {
  const int channels = image.channels == 1 ? 1 : 3;
  std::vector<std::uint8_t> row(static_cast<std::size_t>(image.width * channels));
  Writer writer;
  writer.jpeg.err = jpeg_std_error(&writer.errors);
  writer.errors.error_exit = on_write_error;
  if (!writer.begin(image.width, image.height, channels))
    throw Error(ExitCode::output, name, "could not be encoded: " + writer.message);
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x)
      for (int c = 0; c < channels; ++c)
        row[static_cast<std::size_t>(x * channels + c)] = static_cast<std::uint8_t>(
            std::lround(std::clamp(image.at(x, y, c), 0.0f, 1.0f) * 255.0f));
    if (!writer.write(row.data()))
      throw Error(ExitCode::output, name, "could not be encoded: " + writer.message);
  }
  if (!writer.finish())
    throw Error(ExitCode::output, name, "could not be encoded: " + writer.message);
  const auto* const begin = reinterpret_cast<const std::byte*>(writer.bytes);
  return {begin, begin + writer.size};
}

} // namespace gg::image::formats
