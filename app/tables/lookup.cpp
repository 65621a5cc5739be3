#include "tables/lookup.h"

#include "core/files.h"

#include <map>
#include <mutex>

namespace gg::tables {
namespace {

namespace f64 = gg::glsl::f64;

// Tables by a number, read when first asked for and kept.
template <typename Table, typename Read>
const Table& kept(int key, const Read& read) {
  static std::mutex mutex;
  static std::map<int, Table> tables;
  const std::lock_guard lock(mutex);
  auto found = tables.find(key);
  if (found == tables.end())
    found = tables.emplace(key, read(home_directory() / "assets" / "tables")).first;
  return found->second;
}

int number_of(const Model& model) {
  return static_cast<int>(model.distribution) * 2 + static_cast<int>(model.smith);
}

} // namespace

std::array<double, 4> texel_from(const ReflectionLobeTable& table, int lobe, double cos_theta,
                                 double alpha, double edge) {
  const f64::vec3 u = f64::lobeCoordinateOf(lobe, table.lobes, cos_theta, alpha, edge);
  return lookup<3>(
      table.texels,
      {f64::LOBE_TABLE_SIZE, f64::LOBE_TABLE_SIZE * table.lobes, f64::LOBE_TABLE_SLICES},
      {u.x, u.y, u.z});
}

f64::LobeEnergy reflection_energy_at(const Model& model, double cos_theta, double alpha) {
  const auto& table =
      kept<ReflectionEnergyTable>(number_of(model), [&](const std::filesystem::path& directory) {
        return read_reflection_energy(directory, model);
      });
  const f64::vec2 u = f64::energyCoordinate(cos_theta, alpha);
  const auto t =
      lookup<2>(table.texels, {f64::ENERGY_TABLE_SIZE, f64::ENERGY_TABLE_SIZE}, {u.x, u.y});
  return f64::lobeEnergy(f64::vec4(t[0], t[1], t[2], t[3]));
}

std::array<double, 4> reflection_texel_at(const Model& model, int lobe, int lobes, double cos_theta,
                                          double alpha, double edge) {
  const auto& table = kept<ReflectionLobeTable>(
      8 * lobes + number_of(model), [&](const std::filesystem::path& directory) {
        return read_reflection_lobes(directory, model, lobes);
      });
  return texel_from(table, lobe, cos_theta, alpha, edge);
}

f64::InterfaceEnergy energy_from(const InterfaceEnergyTable& table, double cos_theta, double alpha,
                                 double eta) {
  const f64::vec3 u = f64::interfaceEnergyCoordinate(cos_theta, alpha, eta);
  const auto t = lookup<3>(
      table.texels,
      {f64::INTERFACE_ENERGY_COSINES, f64::INTERFACE_ENERGY_ALPHAS, 2 * f64::INTERFACE_SLICES},
      {u.x, u.y, u.z});
  return f64::interfaceEnergy(f64::vec4(t[0], t[1], t[2], t[3]));
}

f64::InterfaceLobe lobe_from(const InterfaceLobeTable& table, int lobe, double cos_theta,
                             double alpha, double eta) {
  const f64::vec3 u = f64::interfaceLobeCoordinate(lobe, table.lobes, cos_theta, alpha, eta);
  const auto t = lookup<3>(table.texels,
                           {f64::INTERFACE_LOBE_COSINES, f64::INTERFACE_LOBE_ALPHAS * table.lobes,
                            2 * f64::INTERFACE_SLICES},
                           {u.x, u.y, u.z});
  return f64::interfaceLobe(f64::vec4(t[0], t[1], t[2], t[3]), cos_theta, alpha, eta);
}

f64::InterfaceEnergy interface_energy_at(const Model& model, double cos_theta, double alpha,
                                         double eta) {
  const auto& table =
      kept<InterfaceEnergyTable>(number_of(model), [&](const std::filesystem::path& directory) {
        return read_interface_energy(directory, model);
      });
  return energy_from(table, cos_theta, alpha, eta);
}

f64::InterfaceLobe interface_lobe_at(const Model& model, int lobe, int lobes, double cos_theta,
                                     double alpha, double eta) {
  const auto& table = kept<InterfaceLobeTable>(
      8 * lobes + number_of(model), [&](const std::filesystem::path& directory) {
        return read_interface_lobes(directory, model, lobes);
      });
  return lobe_from(table, lobe, cos_theta, alpha, eta);
}

} // namespace gg::tables
