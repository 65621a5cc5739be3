// The files in assets/tables are what the program makes, and damaged ones are refused.
#include "core/error.h"
#include "core/files.h"
#include "glsl/f64.h"
#include "tables/make_interface.h"
#include "tables/make_reflection.h"
#include "tables/make_tables.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <filesystem>

namespace gg::tables {
namespace {

const std::filesystem::path& directory() {
  static const std::filesystem::path path = home_directory() / "assets" / "tables";
  return path;
}

// Half floats keep 11 bits.
void expect_kept(float kept, double made, const std::string& where) {
  EXPECT_NEAR(static_cast<double>(kept), made, 0x1p-11 * std::max(std::abs(made), 0x1p-10))
      << where;
}

TEST(stored_tables, reflected_energies_are_made_again_to_the_last_half_bit) {
  for (const Model& model : models) {
    const ReflectionEnergyTable table = read_reflection_energy(directory(), model);
    for (const auto& [x, y] : {std::pair{0, 40}, {17, 9}, {63, 63}, {31, 20}, {5, 1}}) {
      const EnergyCell made = make_reflection_energy_cell(model, x, y);
      const float* kept = &table.texels[4 * static_cast<std::size_t>(y * 64 + x)];
      const std::string where = name(model) + ' ' + std::to_string(x) + ' ' + std::to_string(y);
      expect_kept(kept[0], made.albedo, where);
      expect_kept(kept[1], made.cos1, where);
      expect_kept(kept[2], made.cos2, where);
      expect_kept(kept[3], made.share1, where);
    }
  }
}

TEST(stored_tables, interface_energies_are_made_again_to_the_last_half_bit) {
  namespace f64 = gg::glsl::f64;
  constexpr int nx = f64::INTERFACE_ENERGY_COSINES, ny = f64::INTERFACE_ENERGY_ALPHAS;
  for (const Model& model : models) {
    const InterfaceEnergyTable table = read_interface_energy(directory(), model);
    for (const auto& [x, y, slice] :
         {std::tuple{0, 20, 0}, {30, 9, 4}, {64, 31, 12}, {31, 12, 17}, {40, 3, 25}, {33, 0, 15}}) {
      const InterfaceShares made = make_interface_energy_cell(model, x, y, slice);
      const float* kept = &table.texels[4 * static_cast<std::size_t>((slice * ny + y) * nx + x)];
      const std::string where = name(model) + ' ' + std::to_string(x) + ' ' + std::to_string(y)
                                + ' ' + std::to_string(slice);
      expect_kept(kept[0], made.transmitted, where);
      expect_kept(kept[1], made.reflected, where);
    }
  }
}

TEST(stored_tables, are_all_there_and_small) {
  std::uintmax_t files = 0, memory = 0;
  for (const Model& model : models)
    for (int lobes = 1; lobes <= lobes_of(model); ++lobes) {
      memory += read_reflection_lobes(directory(), model, lobes).texels.size() * 2;
      memory += read_interface_lobes(directory(), model, lobes).texels.size() * 2;
    }
  for (const auto& entry : std::filesystem::directory_iterator(directory()))
    files += entry.file_size();
  std::printf(
      "    %.2f MB of files; lobes of all models and numbers of lobes %.2f MB on a device\n",
      static_cast<double>(files) * 1e-6, static_cast<double>(memory) * 1e-6);
  EXPECT_LT(files, 6000000u);
}

class Damaged : public testing::Test {
protected:
  Damaged() : path_(std::filesystem::path(GROUNDGLASS_OUTPUT_DIR) / "damaged-tables") {
    std::filesystem::remove_all(path_);
    std::filesystem::create_directories(path_);
  }
  template <typename F>
  std::string message(F&& read) const {
    try {
      read();
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ExitCode::input);
      return error.what();
    }
    return "nothing";
  }
  std::filesystem::path path_;
};

TEST_F(Damaged, files_that_are_missing_are_named) {
  EXPECT_NE(message([&] {
              read_reflection_energy(path_, models[0]);
            }).find("reflection-energy-ggx-separable.exr"),
            std::string::npos);
  EXPECT_NE(message([&] {
              read_interface_lobes(path_, models[2], 2);
            }).find("interface-lobes2-beckmann-separable.exr"),
            std::string::npos);
}

TEST_F(Damaged, values_that_no_table_has_are_named) {
  ReflectionLobeTable table = read_reflection_lobes(directory(), models[0], 1);
  table.texels[4 * 77] = 900.0f;
  write(path_, table);
  const std::string said = message([&] { read_reflection_lobes(path_, models[0], 1); });
  EXPECT_NE(said.find("reflection-lobes1-ggx-separable.exr: holds 900"), std::string::npos) << said;
}

TEST_F(Damaged, files_cut_short_are_refused) {
  write(path_, read_interface_energy(directory(), models[0]));
  std::filesystem::resize_file(path_ / "interface-energy-ggx-separable.exr", 500);
  EXPECT_NE(message([&] {
              read_interface_energy(path_, models[0]);
            }).find("interface-energy-ggx-separable.exr"),
            std::string::npos);
}

TEST_F(Damaged, names_that_no_table_has_are_refused) {
  for (const char* only : {"no such table", "[unclosed"})
    EXPECT_THROW(make_tables(path_, only), Error) << only;
}

} // namespace
} // namespace gg::tables
