#include "tables/reflection_table.h"

#include "core/error.h"
#include "glsl/f64.h"
#include "image/image.h"

#include <cmath>

namespace gg::tables {
namespace {

namespace glsl = gg::glsl::f64;
constexpr int energy_size = glsl::ENERGY_TABLE_SIZE, lobe_size = glsl::LOBE_TABLE_SIZE,
              lobe_slices = glsl::LOBE_TABLE_SLICES;

// What a file holds: its name's stem and its channels, in the order of a texel's components.
struct Layout {
  const char* stem;
  int width, height;
  std::vector<std::string> channels;
  const char* axes;
};
const Layout energy_layout{"reflection-energy-",
                           energy_size,
                           energy_size,
                           {"albedo", "cos1", "cos2", "share1"},
                           "x sqrt(cos theta), y sqrt(alpha), nodes at i / (size - 1)"};
const Layout lobe_layout{"reflection-lobe-",
                         lobe_size,
                         lobe_size* lobe_slices,
                         {"lean", "width"},
                         "x sqrt(cos theta), y sqrt(alpha), nodes at i / (size - 1); below each "
                         "other the share of Schlick's edge, 0 to 1"};

std::filesystem::path file(const std::filesystem::path& directory, const Layout& layout,
                           const Model& model) {
  return directory / (layout.stem + name(model) + ".exr");
}

void write(const std::filesystem::path& directory, const Layout& layout, const Model& model,
           const std::vector<float>& texels) {
  image::Exr exr{layout.width, layout.height, {}, {}, true};
  for (std::size_t c = 0; c < layout.channels.size(); ++c)
    for (std::size_t i = c; i < texels.size(); i += 4)
      exr.channels[layout.channels[c]].push_back(texels[i]);
  exr.attributes["model"] = name(model);
  exr.attributes["axes"] = layout.axes;
  exr.attributes["madeBy"] = "groundglass tables";
  image::write_exr(file(directory, layout, model), exr);
}

std::vector<float> read(const std::filesystem::path& directory, const Layout& layout,
                        const Model& model) {
  const std::filesystem::path path = file(directory, layout, model);
  const image::Exr exr = image::read_exr(path);
  const auto refuse = [&](const std::string& what) {
    throw Error(ExitCode::input, path.string(), what,
                "Make the tables again: groundglass tables -o " + directory.string() + ".");
  };
  if (exr.width != layout.width || exr.height != layout.height)
    refuse("is " + std::to_string(exr.width) + " x " + std::to_string(exr.height) + ", not "
           + std::to_string(layout.width) + " x " + std::to_string(layout.height));
  std::vector<float> texels(
      4 * static_cast<std::size_t>(exr.width) * static_cast<std::size_t>(exr.height), 0.0f);
  for (std::size_t c = 0; c < layout.channels.size(); ++c) {
    const auto plane = exr.channels.find(layout.channels[c]);
    if (plane == exr.channels.end()) refuse("has no channel " + layout.channels[c]);
    for (std::size_t i = 0; i < plane->second.size(); ++i) {
      // Nothing in the tables is beyond 4 (sigma / alpha at grazing angles).
      if (!(plane->second[i] >= 0.0f && plane->second[i] <= 4.0f))
        refuse("holds " + std::to_string(plane->second[i]) + " in channel " + layout.channels[c]);
      texels[4 * i + c] = plane->second[i];
    }
  }
  return texels;
}

} // namespace

CellAxes energy_axes(int x, int y) {
  return {std::pow(x / (energy_size - 1.0), 2.0), std::pow(y / (energy_size - 1.0), 2.0), 0.0};
}

CellAxes lobe_axes(int x, int y, int slice) {
  return {std::pow(x / (lobe_size - 1.0), 2.0), std::pow(y / (lobe_size - 1.0), 2.0),
          slice / (lobe_slices - 1.0)};
}

void write(const std::filesystem::path& directory, const ReflectionTable& table) {
  write(directory, energy_layout, table.model, table.energy);
  write(directory, lobe_layout, table.model, table.lobe);
}

ReflectionTable read(const std::filesystem::path& directory, const Model& model) {
  return {model, read(directory, energy_layout, model), read(directory, lobe_layout, model)};
}

} // namespace gg::tables
