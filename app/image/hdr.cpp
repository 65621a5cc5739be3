// Radiance pictures. Format: G. Ward, "Real Pixels", Graphics Gems II (1991), and "The RADIANCE
// Picture File Format" (radsite.lbl.gov/radiance/refer/filefmts.pdf).
//
// A pixel (r, g, b, e) stands for (r, g, b) * 2^(e - 136), and 0 if e is 0. Radiance itself adds
// half a step when it reads; other readers do not, and only without it 1.0 is read as 1.0, so we do
// not.
#include "core/error.h"
#include "image/formats.h"

#include <array>
#include <charconv>
#include <cmath>
#include <string_view>

namespace gg::image::formats {
namespace {

using Rgbe = std::array<std::uint8_t, 4>;

// The range of widths for which Radiance writes the newer encoding; outside it the four bytes that
// announce it are an ordinary pixel.
constexpr std::size_t newer_encoding_min = 8, newer_encoding_max = 32767;

// A header is a few lines; more than this is not a header.
constexpr std::size_t max_header = 1 << 16;

struct Header {
  // File order: `rows` scan lines of `length` pixels. A scan line runs along y if `transposed`.
  long long rows = 0, length = 0;
  bool transposed = false;
  bool right_to_left = false, bottom_to_top = false;
  std::array<double, 3> applied{1.0, 1.0, 1.0}; // what the stored values were multiplied by
};

class Reader {
public:
  Reader(Bytes bytes, const std::string& name) : bytes_(bytes), name_(name) {}

  Image read() {
    const Header header = read_header();
    const long long width = header.transposed ? header.rows : header.length;
    const long long height = header.transposed ? header.length : header.rows;
    check_size(name_, width, height);
    // The shortest scan line is one pixel and one run of it.
    const std::size_t shortest = header.length > 1 ? 8 : 4;
    if ((bytes_.size() - at_) / shortest < static_cast<std::size_t>(header.rows))
      fail("ends too soon for the " + std::to_string(width) + " x " + std::to_string(height)
           + " pixels that it declares");
    Image image(static_cast<int>(width), static_cast<int>(height), 3);
    std::vector<Rgbe> line(static_cast<std::size_t>(header.length));
    for (row_ = 0; row_ < header.rows; ++row_) {
      read_line(line);
      store(header, line, image);
    }
    return image;
  }

private:
  [[noreturn]] void fail(const std::string& what) const {
    const std::string row = row_ >= 0 ? " (scan line " + std::to_string(row_) + ")" : "";
    throw Error(ExitCode::input, name_ + ", byte " + std::to_string(at_) + row, what,
                "Download or write the file again.");
  }

  std::uint8_t next() {
    if (at_ >= bytes_.size()) fail("ends in the middle of its pixels");
    return std::to_integer<std::uint8_t>(bytes_[at_++]);
  }

  std::string_view next_line() {
    const std::size_t begin = at_;
    while (at_ < bytes_.size() && bytes_[at_] != std::byte{'\n'} && at_ < max_header)
      ++at_;
    if (at_ >= bytes_.size()) fail("ends in the middle of its header");
    if (at_ >= max_header) fail("has no end of its header in its first 64 KiB");
    std::string_view line(reinterpret_cast<const char*>(bytes_.data()) + begin, at_ - begin);
    ++at_;
    if (line.ends_with('\r')) line.remove_suffix(1);
    return line;
  }

  Header read_header() {
    Header header;
    next_line(); // "#?RADIANCE", "#?RGBE" or the name of the program
    for (std::string_view line = next_line(); !line.empty(); line = next_line()) {
      if (line.starts_with("FORMAT=")) {
        check_format(line.substr(7));
      } else if (line.starts_with("EXPOSURE=")) {
        // Every program that rescales adds a line; they multiply.
        const std::array<double, 1> exposure = numbers<1>(line.substr(9), "EXPOSURE");
        for (double& applied : header.applied)
          applied *= exposure[0];
      } else if (line.starts_with("COLORCORR=")) {
        const std::array<double, 3> factors = numbers<3>(line.substr(10), "COLORCORR");
        for (std::size_t c = 0; c < 3; ++c)
          header.applied[c] *= factors[c];
      } else if (line.starts_with("GAMMA=")) {
        if (numbers<1>(line.substr(6), "GAMMA")[0] != 1.0)
          note(name_ + ": its GAMMA is ignored; the values are taken as linear");
      } else if (line.starts_with("PRIMARIES=")) {
        check_primaries(numbers<8>(line.substr(10), "PRIMARIES"));
      }
    }
    for (const double applied : header.applied)
      if (!(applied > 0.0) || !std::isfinite(applied) || !std::isfinite(1.0 / applied))
        fail("has an EXPOSURE or COLORCORR that is out of range");
    read_resolution(header);
    return header;
  }

  void check_format(std::string_view format) const {
    while (format.ends_with(' ') || format.ends_with('\t'))
      format.remove_suffix(1);
    if (format == "32-bit_rle_rgbe") return;
    if (format == "32-bit_rle_xyze")
      throw Error(ExitCode::input, name_, "holds XYZ, not RGB",
                  "Convert it with Radiance's \"ra_xyze -r\".");
    fail("has the unknown FORMAT \"" + std::string(format) + "\"");
  }

  void check_primaries(const std::array<double, 8>& primaries) const {
    if (primaries == std::array<double, 8>{}) return; // what Photoshop writes: not stated
    // Rec. 709 with D65, as written to two or more digits.
    constexpr std::array<double, 8> rec709{.64, .33, .30, .60, .15, .06, .3127, .3290};
    constexpr double two_digits = 0.0051;
    for (std::size_t i = 0; i < 8; ++i)
      if (std::abs(primaries[i] - rec709[i]) > two_digits) {
        note(name_
             + ": its PRIMARIES are not those of Rec. 709; its values are used as if they were");
        return;
      }
  }

  // N numbers separated by blanks.
  template <std::size_t N>
  std::array<double, N> numbers(std::string_view text, const char* key) const {
    std::array<double, N> values{};
    const char *p = text.data(), *const end = p + text.size();
    for (double& value : values) {
      while (p < end && (*p == ' ' || *p == '\t' || *p == '+'))
        ++p;
      const auto [after, error] = std::from_chars(p, end, value);
      if (error != std::errc{} || !std::isfinite(value))
        fail(std::string("has a malformed ") + key + " line");
      p = after;
    }
    return values;
  }

  // "-Y 512 +X 1024": the first axis runs from scan line to scan line, the second along it; -Y is
  // down the picture, +X to its right.
  void read_resolution(Header& header) {
    const std::string_view line = next_line();
    std::string_view rest = line;
    std::array<char, 2> sign{}, axis{};
    std::array<long long, 2> count{};
    for (std::size_t i = 0; i < 2; ++i) {
      while (rest.starts_with(' '))
        rest.remove_prefix(1);
      if (rest.size() < 3 || (rest[0] != '-' && rest[0] != '+')
          || (rest[1] != 'X' && rest[1] != 'Y') || rest[2] != ' ')
        bad_resolution(line);
      sign[i] = rest[0];
      axis[i] = rest[1];
      rest.remove_prefix(3);
      while (rest.starts_with(' '))
        rest.remove_prefix(1);
      const auto [after, error] = std::from_chars(rest.data(), rest.data() + rest.size(), count[i]);
      if (error != std::errc{}) bad_resolution(line);
      rest.remove_prefix(static_cast<std::size_t>(after - rest.data()));
    }
    while (rest.starts_with(' '))
      rest.remove_prefix(1);
    if (!rest.empty() || axis[0] == axis[1]) bad_resolution(line);
    header.transposed = axis[0] == 'X';
    header.rows = count[0];
    header.length = count[1];
    header.bottom_to_top = sign[header.transposed ? 1 : 0] == '+';
    header.right_to_left = sign[header.transposed ? 0 : 1] == '-';
  }

  [[noreturn]] void bad_resolution(std::string_view line) const {
    fail("should give the size like \"-Y 512 +X 1024\" before this place, not \""
         + std::string(line.substr(0, 40)) + "\"");
  }

  void read_line(std::vector<Rgbe>& line) {
    if (line.size() >= newer_encoding_min && line.size() <= newer_encoding_max
        && bytes_.size() - at_ >= 4 && bytes_[at_] == std::byte{2}
        && bytes_[at_ + 1] == std::byte{2} && std::to_integer<unsigned>(bytes_[at_ + 2]) < 128)
      read_newer_line(line);
    else
      read_older_line(line);
  }

  // Four planes, each of runs (128 + count, value) and literals (count, values...).
  void read_newer_line(std::vector<Rgbe>& line) {
    next();
    next();
    const unsigned high = next();
    const std::size_t length = high << 8 | next();
    if (length != line.size())
      fail("has a scan line of " + std::to_string(length) + " pixels where the header says "
           + std::to_string(line.size()));
    for (std::size_t channel = 0; channel < 4; ++channel)
      for (std::size_t x = 0; x < line.size();) {
        const std::size_t code = next();
        const std::size_t count = code > 128 ? code - 128 : code;
        if (count == 0 || count > line.size() - x)
          fail("has a run that does not fit its scan line");
        if (code > 128) {
          const std::uint8_t value = next();
          for (const std::size_t end = x + count; x < end; ++x)
            line[x][channel] = value;
        } else {
          for (const std::size_t end = x + count; x < end; ++x)
            line[x][channel] = next();
        }
      }
  }

  // Pixels as they are, or (1, 1, 1, count): the last pixel again; runs in sequence are the digits
  // of a longer count, lowest first.
  void read_older_line(std::vector<Rgbe>& line) {
    unsigned shift = 0;
    for (std::size_t x = 0; x < line.size();) {
      Rgbe pixel;
      for (std::uint8_t& value : pixel)
        value = next();
      if (pixel[0] == 1 && pixel[1] == 1 && pixel[2] == 1) {
        const std::size_t count = shift <= 24 ? std::size_t{pixel[3]} << shift : 0;
        if (x == 0 || shift > 24 || count > line.size() - x)
          fail("has a run that does not fit its scan line");
        for (const std::size_t end = x + count; x < end; ++x)
          line[x] = line[x - 1];
        shift += 8;
      } else {
        line[x++] = pixel;
        shift = 0;
      }
    }
  }

  void store(const Header& header, const std::vector<Rgbe>& line, Image& image) const {
    const bool exposed = header.applied != std::array<double, 3>{1.0, 1.0, 1.0};
    const int row = static_cast<int>(row_);
    for (int i = 0; i < static_cast<int>(line.size()); ++i) {
      const int x = header.transposed ? row : i, y = header.transposed ? i : row;
      float* const out = &image.at(header.right_to_left ? image.width - 1 - x : x,
                                   header.bottom_to_top ? image.height - 1 - y : y);
      const Rgbe& pixel = line[static_cast<std::size_t>(i)];
      if (pixel[3] == 0) continue; // black, as the image is already
      for (std::size_t c = 0; c < 3; ++c) {
        out[c] = std::ldexp(static_cast<float>(pixel[c]), pixel[3] - 136);
        if (exposed) out[c] = static_cast<float>(static_cast<double>(out[c]) / header.applied[c]);
      }
    }
  }

  Bytes bytes_;
  const std::string& name_;
  std::size_t at_ = 0;
  long long row_ = -1; // the scan line being read; -1: the header
};

} // namespace

Image read_hdr(Bytes bytes, const std::string& name) {
  return Reader(bytes, name).read();
}

} // namespace gg::image::formats
