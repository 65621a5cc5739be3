// The files in assets/tables are what the program makes, and damaged ones are refused.
#include "core/error.h"
#include "tables/gaussian_fit.h"
#include "tables/lookup.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

namespace gg::tables {
namespace {

TEST(stored_tables, energies_are_made_again_to_the_last_half_bit) {
  for (const Model& model : models)
    for (const auto& [x, y] : {std::pair{0, 40}, {17, 9}, {63, 63}, {31, 20}, {5, 1}}) {
      const std::vector<float> made = make_energy_cell(model, x, y);
      for (std::size_t c = 0; c < 4; ++c) {
        const float kept = stored(model).energy[4 * static_cast<std::size_t>(y * 64 + x) + c];
        // half floats: 11 bits
        EXPECT_NEAR(kept, made[c], 0x1p-11f * std::max(made[c], 0x1p-10f))
            << name(model) << ' ' << x << ' ' << y << ' ' << c;
      }
    }
}

TEST(stored_tables, taps_are_made_again) {
  const Training training = make_training(nullptr);
  for (const Model& model : {models[0], models[2]})
    for (const auto& [x, y] : {std::pair{10, 12}, {20, 25}, {31, 18}}) {
      const std::vector<float> made = make_lobe_column(model, training, x, y);
      for (int slice : {0, 1, 2})
        for (int c = 0; c < 2; ++c) {
          const float value = made[static_cast<std::size_t>(2 * slice + c)];
          const float kept =
              stored(model).lobe[4 * static_cast<std::size_t>((slice * 32 + y) * 32 + x)
                                 + static_cast<std::size_t>(c)];
          // Other compilers round other lookups: a flat minimum then ends a little elsewhere.
          EXPECT_NEAR(kept, value, 0.01f)
              << name(model) << ' ' << x << ' ' << y << ' ' << slice << ' ' << c;
        }
    }
}

TEST(stored_tables, damaged_files_are_refused_by_name) {
  const std::filesystem::path directory = std::filesystem::path(GROUNDGLASS_OUTPUT_DIR) / "tables";
  std::filesystem::create_directories(directory);
  const auto message = [&] {
    try {
      read(directory, models[0]);
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ExitCode::input);
      return std::string(error.what());
    }
    return std::string("nothing");
  };
  for (const auto& entry : std::filesystem::directory_iterator(directory))
    std::filesystem::remove(entry.path());
  EXPECT_NE(message().find("reflection-energy-ggx-separable.exr"), std::string::npos) << message();
  ReflectionTable table = stored(models[0]);
  table.lobe[4 * 77] = 900.0f;
  write(directory, table);
  EXPECT_NE(message().find("reflection-lobe-ggx-separable.exr: holds 900"), std::string::npos)
      << message();
  std::filesystem::resize_file(directory / "reflection-energy-ggx-separable.exr", 500);
  EXPECT_NE(message().find("reflection-energy-ggx-separable.exr"), std::string::npos) << message();
}

} // namespace
} // namespace gg::tables
