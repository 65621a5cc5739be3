// Pictures with standard errors and object ids, from EXR channels.
#include "core/error.h"
#include "core/files.h"
#include "image/compare.h"
#include "image/formats.h"

#include <charconv>
#include <cmath>

namespace gg::image {
namespace {

[[noreturn]] void bad_value(const std::string& name, const std::string& channel, std::size_t pixel,
                            int width, const std::string& what) {
  const std::size_t w = static_cast<std::size_t>(width);
  throw Error(ExitCode::input,
              name + ", channel " + channel + ", pixel (" + std::to_string(pixel % w) + ", "
                  + std::to_string(pixel / w) + ")",
              what, "Render the picture again.");
}

// Takes the channel if it is there; `valid` says what its values may be.
template <class Valid>
std::vector<float> take(Exr& exr, const std::string& name, const std::string& channel,
                        const Valid& valid, const std::string& rule) {
  const auto it = exr.channels.find(channel);
  if (it == exr.channels.end()) return {};
  for (std::size_t i = 0; i < it->second.size(); ++i)
    if (!valid(it->second[i]))
      bad_value(name, channel, i, exr.width,
                "is " + std::to_string(it->second[i]) + ", not " + rule);
  return std::move(it->second);
}

std::optional<Image> standard_error(Exr& exr, const std::string& name) {
  Image image(exr.width, exr.height, 3);
  for (std::size_t c = 0; c < 3; ++c) {
    const std::vector<float> plane = take(
        exr, name, std::string("stderr.") + "RGB"[c],
        [](float v) { return std::isfinite(v) && v >= 0.0f; }, "zero or a positive number");
    if (plane.empty()) return {};
    for (std::size_t i = 0; i < plane.size(); ++i)
      image.values[i * 3 + c] = plane[i];
  }
  return image;
}

std::map<int, std::string> object_names(const Exr& exr) {
  std::map<int, std::string> names;
  const std::string prefix = "object.";
  for (const auto& [key, value] : exr.attributes) {
    int id = 0;
    const char* const end = key.data() + key.size();
    if (key.starts_with(prefix) && std::from_chars(key.data() + prefix.size(), end, id).ptr == end)
      names[id] = value;
  }
  return names;
}

} // namespace

Picture load_picture(const std::filesystem::path& path) {
  Picture picture{.name = path.string(), .colour = {}};
  const std::vector<std::byte> bytes = read_file(path);
  const formats::Format format = formats::recognise(bytes);
  picture.display_referred = format == formats::Format::png || format == formats::Format::jpeg
                             || format == formats::Format::webp || format == formats::Format::ktx2;
  if (format == formats::Format::exr) {
    Exr exr = formats::read_exr(bytes, picture.name);
    picture.colour = formats::colour_of(exr, picture.name);
    picture.standard_error = standard_error(exr, picture.name);
    constexpr float exact_integers = 1 << 24; // of a float
    picture.id = take(
        exr, picture.name, "id",
        [](float v) { return v >= 0.0f && v <= exact_integers && v == std::floor(v); },
        "a whole number from 0");
    picture.coverage = take(
        exr, picture.name, "coverage", [](float v) { return v >= 0.0f && v <= 1.0f; },
        "from 0 to 1");
    picture.object_names = object_names(exr);
  } else {
    picture.colour = read(path);
  }
  require_finite(picture.colour, picture.name);
  return picture;
}

} // namespace gg::image
