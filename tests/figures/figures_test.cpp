// The figures: what they claim, that all of them are written, and that they are the same every
// time.
#include "core/error.h"
#include "core/files.h"
#include "figures/curves.h"
#include "figures/figures.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <set>

namespace {

using namespace gg;
namespace fs = std::filesystem;

constexpr double degree = std::numbers::pi / 180.0;
// Of mean directions: halving the quadrature's steps moves none of them by more than this.
constexpr double quadrature = 0.1 * degree;

fs::path fresh_folder(const std::string& name) {
  const fs::path folder = fs::path(GROUNDGLASS_OUTPUT_DIR) / name;
  fs::remove_all(folder);
  return folder;
}

TEST(figures, all_are_written_twice_with_the_same_bytes) {
  const fs::path a = fresh_folder("figures_a"), b = fresh_folder("figures_b");
  const auto names = figures::write_all(a);
  EXPECT_EQ(names, figures::write_all(b));
  EXPECT_EQ(names.size(), std::set(names.begin(), names.end()).size());
  for (const std::string& name : names) {
    const std::string text = read_text(a / name);
    EXPECT_EQ(text, read_text(b / name)) << name;
    const bool png = name.ends_with(".png");
    EXPECT_TRUE(text.starts_with(png ? "\x89PNG" : "<?xml")) << name;
    EXPECT_NE(text.find(png ? "IEND" : "</svg>"), std::string::npos) << name;
  }
}

TEST(figures, unwritable_directory_is_an_output_error) {
  const fs::path file = fs::path(GROUNDGLASS_OUTPUT_DIR) / "figures_file";
  fs::create_directories(file.parent_path());
  std::ofstream(file) << "in the way";
  try {
    figures::write_all(file);
    FAIL() << "wrote into a file";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ExitCode::output);
  }
}

TEST(figures, mean_direction_goes_over_into_mirror_and_snell_as_alpha_vanishes) {
  for (const double incidence : {10.0 * degree, 40.0 * degree, 70.0 * degree}) {
    // GGX's tail falls as alpha² log(1 / alpha): at 1e-3 it moves the mean by some 1e-5.
    EXPECT_NEAR(figures::mean_reflected(incidence, 1e-3, 1.5), incidence, quadrature);
    EXPECT_NEAR(figures::mean_transmitted(incidence, 1e-3, 1.5),
                std::asin(std::sin(incidence) / 1.5), quadrature);
  }
}

TEST(figures, refracted_light_is_bent_less_than_snell_says) {
  // Measured beforehand by brute force over outgoing directions: 41.3 degrees where Snell
  // says 35.3.
  EXPECT_NEAR(figures::mean_transmitted(60.0 * degree, 0.3, 1.5), 41.3 * degree, quadrature);
}

TEST(figures, rough_glass_transmits_past_the_critical_angle_where_smooth_does_not) {
  const figures::Lobe lobe = figures::transmitted_lobe(60.0 * degree, 0.3, 1.0 / 1.5);
  EXPECT_FALSE(lobe.ideal.has_value());
  double largest = 0.0;
  for (const figures::Point& p : lobe.points)
    largest = std::max(largest, p.y);
  EXPECT_GT(largest, 0.1);
}

} // namespace
