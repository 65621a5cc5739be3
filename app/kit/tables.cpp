#include "kit/tables.h"

#include "core/files.h"
#include "glsl/f32.h"
#include "tables/interface_table.h"
#include "tables/reflection_table.h"

#include <glm/gtc/packing.hpp>
#include <nlohmann/json.hpp>

#include <array>
#include <span>
#include <vector>

namespace gg::kit {
namespace fs = std::filesystem;
namespace {

using Json = nlohmann::ordered_json;

void write_halves(const fs::path& path, const std::vector<float>& texels) {
  std::vector<std::uint16_t> halves(texels.size());
  for (std::size_t i = 0; i < texels.size(); ++i)
    halves[i] = glm::packHalf1x16(texels[i]);
  OutputFile file(path);
  file.write(std::as_bytes(std::span(halves)));
  file.commit();
}

Json described(const std::string& file, std::array<int, 3> size, const std::string& channels,
               const std::string& axes) {
  return {{"file", file},
          {"size", size},
          {"format", "RGBA half float, little endian, x fastest, then y, then z"},
          {"channels", channels},
          {"axes", axes},
          {"filtering", "linear along all three axes, clamped to the edge"}};
}

} // namespace

void write_tables(const fs::path& home, const fs::path& directory) {
  namespace g = gg::glsl::f32;
  Json textures;
  const std::string axes = "see interfaceEnergyCoordinate and interfaceLobeCoordinate in the "
                           "shaders: x cosine of the viewer's direction, y sqrt(alpha), "
                           "z (n - 1) / (n + 1) for n from 1 to 4, entering before leaving";
  for (const tables::Distribution distribution :
       {tables::Distribution::ggx, tables::Distribution::beckmann}) {
    const tables::Model model{distribution, tables::Smith::separable};
    const std::string name = distribution == tables::Distribution::ggx ? "ggx" : "beckmann";
    const std::string energy = "interface-energy-" + name, lobes = "interface-lobes2-" + name,
                      reflection = "reflection-lobes1-" + name;
    const fs::path stored = home / "assets" / "tables";
    write_halves(directory / (energy + ".bin"),
                 tables::read_interface_energy(stored, model).texels);
    write_halves(directory / (lobes + ".bin"),
                 tables::read_interface_lobes(stored, model, 2).texels);
    textures[energy] = described(
        energy + ".bin",
        {g::INTERFACE_ENERGY_COSINES, g::INTERFACE_ENERGY_ALPHAS, 2 * g::INTERFACE_SLICES},
        "transmitted, reflected, 0, 0", axes);
    textures[lobes] = described(
        lobes + ".bin",
        {g::INTERFACE_LOBE_COSINES, 2 * g::INTERFACE_LOBE_ALPHAS, 2 * g::INTERFACE_SLICES},
        "(angle - Snell's) / width, sigma / width, weight, 0",
        axes + "; along y the first lobe's block before the second's");
    write_halves(directory / (reflection + ".bin"),
                 tables::read_reflection_lobes(stored, model, 1).texels);
    textures[reflection] = described(reflection + ".bin",
                                     {g::LOBE_TABLE_SIZE, g::LOBE_TABLE_SIZE, g::LOBE_TABLE_SLICES},
                                     "lean, sigma / alpha, weight, 0",
                                     "see lobeCoordinate in the shaders: x sqrt of the viewer's "
                                     "cosine, y sqrt(alpha), z share of the edge");
  }
  OutputFile description(directory / "tables.json");
  description.write(Json{{"textures", textures}}.dump(2) + "\n");
  description.commit();
}

} // namespace gg::kit
