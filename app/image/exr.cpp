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

// `values`: `channels` of each pixel of `from`, of which those in `to` are kept; 0 elsewhere.
std::vector<float> moved(const std::vector<float>& values, std::ptrdiff_t channels,
                         const Imath::Box2i& from, const Imath::Box2i& to) {
  const auto row = [&](const Imath::Box2i& box) {
    return channels * (static_cast<std::ptrdiff_t>(box.max.x) - box.min.x + 1);
  };
  const std::ptrdiff_t rows = static_cast<std::ptrdiff_t>(to.max.y) - to.min.y + 1;
  std::vector<float> result(static_cast<std::size_t>(row(to) * rows), 0.0f);
  const int left = std::max(from.min.x, to.min.x), right = std::min(from.max.x, to.max.x);
  for (int y = std::max(from.min.y, to.min.y); y <= std::min(from.max.y, to.max.y); ++y)
    std::copy_n(values.begin() + (y - from.min.y) * row(from) + channels * (left - from.min.x),
                channels * (right - left + 1),
                result.begin() + (y - to.min.y) * row(to) + channels * (left - to.min.x));
  return result;
}

// Which channels are colour: those of the unnamed layer or else of the only one. Layers are the parts of names before the
// last point: "ViewLayer.Combined.R".
std::vector<std::string> colour_channels(const std::set<std::string>& names,
                                         const std::string& file) {
  std::set<std::string> layers;
  std::string listed;
  for (const std::string& channel : names) {
    listed += (listed.empty() ? "" : ", ") + channel;
    const std::size_t point = channel.rfind('.');
    const std::string layer = point == std::string::npos ? "" : channel.substr(0, point + 1);
    if (names.contains(layer + "R") && names.contains(layer + "G") && names.contains(layer + "B"))
      layers.insert(layer);
  }
  if (layers.contains("") || layers.size() == 1) {
    const std::string layer = layers.contains("") ? "" : *layers.begin();
    std::vector<std::string> colours{layer + "R", layer + "G", layer + "B"};
    if (names.contains(layer + "A")) colours.push_back(layer + "A");
    return colours;
  }
  if (layers.empty() && names.contains("Y")) return {"Y"};
  throw Error(ExitCode::input, file,
              (layers.empty() ? "has no colour: its channels are "
                              : "has several layers of colour and none without a name: ")
                  + listed,
              "Save it with channels R, G and B.");
}

// A file whose header is read and accepted. No memory is taken for its pixels yet.
struct Opened {
  MemoryInput stream;
  Imf::InputFile file;
  const Imf::Header& header;
  Imath::Box2i window, shown;      // of the data; of the picture
  std::size_t row = 0, pixels = 0; // of the data
  std::set<std::string> channels;
  bool half = true; // all but "id"

  Opened(Bytes bytes, const std::string& name)
      : stream(bytes, name), file(stream, 0), header(file.header()), window(header.dataWindow()) {
    check_size(name, static_cast<long long>(window.max.x) - window.min.x + 1,
               static_cast<long long>(window.max.y) - window.min.y + 1);
    note_primaries(header, name);
    shown = shown_window(header, name);
    row = static_cast<std::size_t>(window.max.x - window.min.x + 1);
    pixels = row * static_cast<std::size_t>(window.max.y - window.min.y + 1);
    check_ratio(header, pixels, bytes.size(), name);
    // Where the windows differ, both pictures are held while one becomes the other.
    const std::size_t held = pixels
                             + (shown == window ? 0
                                                : static_cast<std::size_t>(width())
                                                      * static_cast<std::size_t>(height()));
    for (auto it = header.channels().begin(); it != header.channels().end(); ++it) {
      const Imf::Channel& channel = it.channel();
      if (channel.xSampling != 1 || channel.ySampling != 1)
        throw Error(ExitCode::input, name + ", channel " + it.name(),
                    "holds one value for several pixels (luminance and chroma)",
                    "Save it with R, G and B channels.");
      channels.insert(it.name());
      if (channels.size() > max_channels
          || static_cast<long long>(held * channels.size()) > max_values)
        throw Error(ExitCode::input, name, "has more channels than are accepted of its size",
                    "Save it with the channels that are needed only.");
      if (std::string_view(it.name()) != "id") half &= channel.type == Imf::HALF;
    }
    if (channels.empty())
      throw Error(ExitCode::input, name, "has no channels", "Save it again with some.");
  }
  int width() const { return shown.max.x - shown.min.x + 1; }
  int height() const { return shown.max.y - shown.min.y + 1; }

  // Where a channel goes: to every `step`-th value from `first` on.
  void put(Imf::FrameBuffer& frame, const std::string& channel, float* first,
           std::size_t step) const {
    frame.insert(channel, Imf::Slice::Make(Imf::FLOAT, first, window, sizeof(float) * step,
                                           sizeof(float) * step * row));
  }
  void read(const Imf::FrameBuffer& frame) {
    file.setFrameBuffer(frame);
    file.readPixels(window.min.y, window.max.y);
  }
};

Exr read_planes(Bytes bytes, const std::string& name) {
  Opened opened(bytes, name);
  Exr exr{.width = opened.width(),
          .height = opened.height(),
          .channels = {},
          .attributes = attributes_of(opened.header),
          .half = opened.half};
  Imf::FrameBuffer frame;
  for (const std::string& channel : opened.channels) {
    std::vector<float>& plane = exr.channels[channel];
    plane.resize(opened.pixels);
    opened.put(frame, channel, plane.data(), 1);
  }
  opened.read(frame);
  if (opened.shown != opened.window)
    for (auto& [channel, plane] : exr.channels)
      plane = moved(plane, 1, opened.window, opened.shown);
  return exr;
}

// Straight into the picture: a large panorama is in memory once.
Image read_colour(Bytes bytes, const std::string& name) {
  Opened opened(bytes, name);
  const std::vector<std::string> colours = colour_channels(opened.channels, name);
  const std::size_t channels = std::max(colours.size(), std::size_t{3});
  Image image;
  image.width = opened.width(), image.height = opened.height();
  image.channels = static_cast<int>(channels);
  image.values.resize(opened.pixels * channels);
  Imf::FrameBuffer frame;
  for (std::size_t c = 0; c < colours.size(); ++c)
    opened.put(frame, colours[c], &image.values[c], channels);
  opened.read(frame);
  if (colours.size() == 1) // grey
    for (std::size_t i = 0; i < image.values.size(); i += channels)
      image.values[i + 1] = image.values[i + 2] = image.values[i];
  if (opened.shown != opened.window)
    image.values = moved(image.values, image.channels, opened.window, opened.shown);
  return image;
}

// What the library throws, in our words.
template <class Read>
auto read_by(const Read& read, Bytes bytes, const std::string& name) {
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
    return read(bytes, name);
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

} // namespace

Exr read_exr(Bytes bytes, const std::string& name) {
  return read_by(read_planes, bytes, name);
}

Image read_exr_colour(Bytes bytes, const std::string& name) {
  return read_by(read_colour, bytes, name);
}

Image colour_of(const Exr& exr, const std::string& name) {
  std::set<std::string> names;
  for (const auto& [channel, plane] : exr.channels)
    names.insert(channel);
  const std::vector<std::string> colours = colour_channels(names, name);
  Image image(exr.width, exr.height, std::max(static_cast<int>(colours.size()), 3));
  const auto channels = static_cast<std::size_t>(image.channels);
  for (std::size_t c = 0; c < channels; ++c) {
    const std::vector<float>& plane = exr.channels.at(colours[std::min(c, colours.size() - 1)]);
    for (std::size_t i = 0; i < plane.size(); ++i)
      image.values[i * channels + c] = plane[i];
  }
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
