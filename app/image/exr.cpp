// OpenEXR pictures, by the OpenEXR library: any number of named channels, half or float or uint,
// scan lines or tiles (level 0), first part.
#include "core/error.h"
#include "image/exr_streams.h"
#include "image/formats.h"

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfDoubleAttribute.h>
#include <OpenEXR/ImfFloatAttribute.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfInputFile.h>
#include <OpenEXR/ImfIntAttribute.h>
#include <OpenEXR/ImfOutputFile.h>
#include <OpenEXR/ImfStandardAttributes.h>
#include <OpenEXR/ImfStringAttribute.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <set>

namespace gg::image::formats {
namespace {

// Enough for the truth's planes many times over; each costs a plane of floats.
constexpr int max_channels = 64;
constexpr long long max_values = 4 * max_pixels; // 2 GB

// How much smaller than its pixels a file can be at most. Deflate reaches 1032 (258 bytes for two
// bits), and the 24-bit floats of PXR24 4/3 of that; the other exact methods stay below. DWA keeps
// one deflated half for each 8 x 8 floats: 64 * 4 / 2 * 1032.
std::uint64_t densest(Imf::Compression compression) {
  const bool dwa = compression == Imf::DWAA_COMPRESSION || compression == Imf::DWAB_COMPRESSION;
  return dwa ? 128 * 1032 : 4 * 1032 / 3;
}

// Before memory is taken for the pixels.
void check_ratio(const Imf::Header& header, std::uint64_t pixels, std::size_t file_bytes,
                 const std::string& name) {
  std::uint64_t pixel_bytes = 0;
  for (auto it = header.channels().begin(); it != header.channels().end(); ++it)
    pixel_bytes += it.channel().type == Imf::HALF ? 2 : 4;
  if (pixels * pixel_bytes / densest(header.compression()) <= file_bytes) return;
  throw Error(ExitCode::input, name,
              "declares " + std::to_string(pixels) + " pixels, which its "
                  + std::to_string(file_bytes) + " bytes cannot hold",
              "Download or write the file again.");
}

template <class Number>
std::string text_of(Number value) {
  std::array<char, 64> digits{};
  const auto [end, error] = std::to_chars(digits.data(), digits.data() + digits.size(), value);
  return {digits.data(), end};
}

std::map<std::string, std::string> attributes_of(const Imf::Header& header) {
  std::map<std::string, std::string> attributes;
  for (auto it = header.begin(); it != header.end(); ++it) {
    const Imf::Attribute* const a = &it.attribute();
    if (const auto* text = dynamic_cast<const Imf::StringAttribute*>(a))
      attributes[it.name()] = text->value();
    else if (const auto* whole = dynamic_cast<const Imf::IntAttribute*>(a))
      attributes[it.name()] = text_of(whole->value());
    else if (const auto* single = dynamic_cast<const Imf::FloatAttribute*>(a))
      attributes[it.name()] = text_of(single->value());
    else if (const auto* twice = dynamic_cast<const Imf::DoubleAttribute*>(a))
      attributes[it.name()] = text_of(twice->value());
  }
  return attributes;
}

void note_primaries(const Imf::Header& header, const std::string& name) {
  if (!Imf::hasChromaticities(header)) return;
  const Imf::Chromaticities rec709; // the library's default
  const Imf::Chromaticities& own = Imf::chromaticities(header);
  constexpr float two_digits = 0.0051f; // as primaries are often written
  const bool same = own.red.equalWithAbsError(rec709.red, two_digits)
                    && own.green.equalWithAbsError(rec709.green, two_digits)
                    && own.blue.equalWithAbsError(rec709.blue, two_digits)
                    && own.white.equalWithAbsError(rec709.white, two_digits);
  if (!same)
    note(name + ": its primaries are not those of Rec. 709; its values are used as if they were");
}

// The window that the picture is meant to fill. Programs save only the part that holds something (the data window), or
// more than that (overscan). A display window that has nothing of the data, or is so much larger that the file
// could make the program take memory that it has no use for, is no guide: then the data window counts.
Imath::Box2i shown_window(const Imf::Header& header, const std::string& name) {
  const Imath::Box2i data = header.dataWindow(), display = header.displayWindow();
  if (data == display) return data;
  const auto pixels = [](const Imath::Box2i& box) {
    return (static_cast<double>(box.max.x) - box.min.x + 1)
           * (static_cast<double>(box.max.y) - box.min.y + 1);
  };
  constexpr double sparsest = 64.0;
  if (!display.intersects(data) || pixels(display) > sparsest * pixels(data)) {
    note(name
         + ": its display window has next to nothing of its data window, which is used instead");
    return data;
  }
  check_size(name, static_cast<long long>(display.max.x) - display.min.x + 1,
             static_cast<long long>(display.max.y) - display.min.y + 1);
  if (!display.intersects(data.min) || !display.intersects(data.max))
    note(name + ": what lies outside its display window is not used");
  if (!data.intersects(display.min) || !data.intersects(display.max))
    note(name + ": its data window is smaller than its display window; the rest is black");
  return display;
}

std::vector<float> moved(const std::vector<float>& plane, const Imath::Box2i& from,
                         const Imath::Box2i& to) {
  const auto width = [](const Imath::Box2i& box) {
    return static_cast<std::ptrdiff_t>(box.max.x) - box.min.x + 1;
  };
  const std::ptrdiff_t rows = static_cast<std::ptrdiff_t>(to.max.y) - to.min.y + 1;
  std::vector<float> result(static_cast<std::size_t>(width(to) * rows), 0.0f);
  const int left = std::max(from.min.x, to.min.x), right = std::min(from.max.x, to.max.x);
  for (int y = std::max(from.min.y, to.min.y); y <= std::min(from.max.y, to.max.y); ++y)
    std::copy_n(plane.begin() + (y - from.min.y) * width(from) + (left - from.min.x),
                right - left + 1, result.begin() + (y - to.min.y) * width(to) + (left - to.min.x));
  return result;
}

Exr read_file(Bytes bytes, const std::string& name) {
  MemoryInput stream(bytes, name);
  Imf::InputFile file(stream, 0);
  const Imf::Header& header = file.header();
  const Imath::Box2i window = header.dataWindow();
  check_size(name, static_cast<long long>(window.max.x) - window.min.x + 1,
             static_cast<long long>(window.max.y) - window.min.y + 1);
  note_primaries(header, name);

  const Imath::Box2i shown = shown_window(header, name);
  Exr exr;
  exr.width = shown.max.x - shown.min.x + 1;
  exr.height = shown.max.y - shown.min.y + 1;
  exr.attributes = attributes_of(header);
  const std::size_t row = static_cast<std::size_t>(window.max.x - window.min.x + 1);
  const std::size_t pixels = row * static_cast<std::size_t>(window.max.y - window.min.y + 1);
  const std::size_t largest =
      std::max(pixels, static_cast<std::size_t>(exr.width) * static_cast<std::size_t>(exr.height));
  check_ratio(header, pixels, bytes.size(), name);
  Imf::FrameBuffer frame;
  bool all_half = true;
  int count = 0;
  for (auto it = header.channels().begin(); it != header.channels().end(); ++it) {
    const Imf::Channel& channel = it.channel();
    if (channel.xSampling != 1 || channel.ySampling != 1)
      throw Error(ExitCode::input, name + ", channel " + it.name(),
                  "holds one value for several pixels (luminance and chroma)",
                  "Save it with R, G and B channels.");
    if (++count > max_channels || static_cast<long long>(largest) * count > max_values)
      throw Error(ExitCode::input, name, "has more channels than are accepted",
                  "Save it with the channels that are needed only.");
    if (std::string_view(it.name()) != "id") all_half &= channel.type == Imf::HALF;
    std::vector<float>& plane = exr.channels[it.name()];
    plane.resize(pixels);
    frame.insert(it.name(), Imf::Slice::Make(Imf::FLOAT, plane.data(), window, sizeof(float),
                                             sizeof(float) * row));
  }
  if (count == 0) throw Error(ExitCode::input, name, "has no channels", "Save it again with some.");
  exr.half = all_half;
  file.setFrameBuffer(frame);
  file.readPixels(window.min.y, window.max.y);
  if (shown != window)
    for (auto& [channel, plane] : exr.channels)
      plane = moved(plane, window, shown);
  return exr;
}

} // namespace

Exr read_exr(Bytes bytes, const std::string& name) {
  if (recognise(bytes) != Format::exr)
    throw Error(ExitCode::input, name, "is not an OpenEXR picture", "Name an .exr file.");
  // The library takes memory for line tables and tiles as soon as it has read the header.
  static const bool limited = [] {
    Imf::Header::setMaxImageSize(static_cast<int>(max_side), static_cast<int>(max_side));
    Imf::Header::setMaxTileSize(4096, 4096);
    return true;
  }();
  (void)limited;
  try {
    return read_file(bytes, name);
  } catch (const Error&) {
    throw;
  } catch (const std::exception& error) {
    std::string what = error.what();
    // The library names the file too.
    const std::string named = "\"" + name + "\". ";
    if (const std::size_t at = what.find(named); at != std::string::npos)
      what.erase(0, at + named.size());
    while (!what.empty() && (what.back() == '.' || what.back() == '\n'))
      what.pop_back();
    throw Error(ExitCode::input, name, "is truncated or malformed: " + what,
                "Download or write the file again.");
  }
}

Image colour_of(const Exr& exr, const std::string& name) {
  // Layers are the parts of names before the last point: "ViewLayer.Combined.R".
  std::set<std::string> layers;
  std::string listed;
  for (const auto& [channel, plane] : exr.channels) {
    listed += (listed.empty() ? "" : ", ") + channel;
    const std::size_t point = channel.rfind('.');
    const std::string layer = point == std::string::npos ? "" : channel.substr(0, point + 1);
    if (exr.channels.contains(layer + "R") && exr.channels.contains(layer + "G")
        && exr.channels.contains(layer + "B"))
      layers.insert(layer);
  }
  std::vector<const std::vector<float>*> planes;
  if (layers.contains("") || layers.size() == 1) {
    const std::string layer = layers.contains("") ? "" : *layers.begin();
    for (const char* const part : {"R", "G", "B", "A"})
      if (const auto it = exr.channels.find(layer + part); it != exr.channels.end())
        planes.push_back(&it->second);
  } else if (const auto grey = exr.channels.find("Y");
             layers.empty() && grey != exr.channels.end()) {
    planes.assign(3, &grey->second);
  } else {
    throw Error(ExitCode::input, name,
                (layers.empty() ? "has no colour: its channels are "
                                : "has several layers of colour and none without a name: ")
                    + listed,
                "Save it with channels R, G and B.");
  }
  Image image(exr.width, exr.height, static_cast<int>(planes.size()));
  const std::size_t channels = planes.size();
  for (std::size_t c = 0; c < channels; ++c)
    for (std::size_t i = 0; i < planes[c]->size(); ++i)
      image.values[i * channels + c] = (*planes[c])[i];
  return image;
}

std::vector<std::byte> encode_exr(const Exr& exr, const std::string& name) {
  const std::size_t pixels =
      exr.width > 0 && exr.height > 0
          ? static_cast<std::size_t>(exr.width) * static_cast<std::size_t>(exr.height)
          : 0;
  if (pixels == 0 || exr.channels.empty())
    throw Error(ExitCode::internal, name, "a picture without pixels or channels cannot be written");
  Imf::Header header(exr.width, exr.height);
  header.compression() = Imf::ZIP_COMPRESSION;
  for (const auto& [key, value] : exr.attributes)
    header.insert(key, Imf::StringAttribute(value));
  const std::size_t row = static_cast<std::size_t>(exr.width);
  std::map<std::string, std::vector<half>> halves;
  Imf::FrameBuffer frame;
  for (const auto& [channel, plane] : exr.channels) {
    if (plane.size() != pixels)
      throw Error(ExitCode::internal, name, "channel " + channel + " has the wrong size");
    const bool as_half = exr.half && channel != "id";
    const Imf::PixelType type = as_half ? Imf::HALF : Imf::FLOAT;
    header.channels().insert(channel, Imf::Channel(type));
    if (as_half) halves[channel].assign(plane.begin(), plane.end());
    const void* const values = as_half ? static_cast<const void*>(halves[channel].data())
                                       : static_cast<const void*>(plane.data());
    const std::size_t size = as_half ? sizeof(half) : sizeof(float);
    // The library reads through the pointer only; its type is shared with reading.
    frame.insert(channel,
                 Imf::Slice(type, static_cast<char*>(const_cast<void*>(values)), size, size * row));
  }
  try {
    MemoryOutput stream(name);
    {
      Imf::OutputFile file(stream, header, 0);
      file.setFrameBuffer(frame);
      file.writePixels(exr.height);
    } // its destructor writes the table of scan lines
    return stream.take();
  } catch (const std::exception& error) {
    throw Error(ExitCode::internal, name, std::string("could not be encoded: ") + error.what());
  }
}

} // namespace gg::image::formats
