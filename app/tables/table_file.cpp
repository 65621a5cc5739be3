#include "tables/table_file.h"

#include "core/error.h"
#include "image/image.h"

namespace gg::tables {
namespace {

std::filesystem::path file(const std::filesystem::path& directory, const TableLayout& layout,
                           const Model& model) {
  return directory / (layout.stem + name(model) + ".exr");
}

} // namespace

void write_table(const std::filesystem::path& directory, const TableLayout& layout,
                 const Model& model, const std::vector<float>& texels) {
  image::Exr exr{layout.width, layout.height, {}, {}, true};
  for (std::size_t c = 0; c < layout.channels.size(); ++c)
    for (std::size_t i = c; i < texels.size(); i += 4)
      exr.channels[layout.channels[c]].push_back(texels[i]);
  exr.attributes["model"] = name(model);
  exr.attributes["axes"] = layout.axes;
  exr.attributes["madeBy"] = "groundglass tables";
  image::write_exr(file(directory, layout, model), exr);
}

std::vector<float> read_table(const std::filesystem::path& directory, const TableLayout& layout,
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
      if (!(plane->second[i] >= layout.least && plane->second[i] <= layout.greatest))
        refuse("holds " + std::to_string(plane->second[i]) + " in channel " + layout.channels[c]);
      texels[4 * i + c] = plane->second[i];
    }
  }
  return texels;
}

} // namespace gg::tables
