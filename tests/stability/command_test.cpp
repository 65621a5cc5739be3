// groundglass eval and groundglass figures as a user meets them.
#include "core/error.h"
#include "core/files.h"
#include "support/program.h"
#include "support/scratch.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <sstream>

namespace gg::test {
namespace {

namespace fs = std::filesystem;

const std::string header = "id,lobe,dist,alpha,eta,cn,ck,ix,iy,iz,ox,oy,oz,nx,ny,nz\n";
const std::string row = ",R,ggx,0.3,1.5,0,0,0.6,0,0.8,-0.6,0,0.8,0,0,1\n";

Finished eval(const std::string& text, const std::vector<std::string>& more, const fs::path& out) {
  std::vector<std::string> words = {"eval", "--in", scratch_file("queries.csv", text), "--output",
                                    out};
  words.insert(words.end(), more.begin(), more.end());
  return run_program(words);
}

TEST(eval, writes_17_digits_on_cpu_and_9_on_a_device) {
  const fs::path out = scratch_directory() / "values.csv";
  ASSERT_EQ(eval(header + "a" + row, {"--backend", "cpu"}, out).code, 0);
  const std::string expected = "id,D,G,G2,F,omF,f,f_cos,f_G2,pdf_D,pdf_vndf\na,3.536776";
  EXPECT_TRUE(read_text(out).starts_with(expected)) << read_text(out);
  const auto longest = [&] {
    std::istringstream fields(read_text(out).substr(expected.find('\n')));
    std::size_t digits = 0;
    for (std::string field; std::getline(fields, field, ',');)
      digits = std::max(
          digits, static_cast<std::size_t>(std::count_if(field.begin(), field.end(), ::isdigit)));
    return digits;
  };
  EXPECT_GE(longest(), 16u);
  ASSERT_EQ(eval(header + "a" + row, {"--backend", "opengl"}, out).code, 0);
  EXPECT_TRUE(read_text(out).starts_with(expected)) << read_text(out);
  EXPECT_LE(longest(), 11u);
}

TEST(eval, keeps_ids_and_order_across_batches) {
  constexpr int rows = 150000; // more than two batches
  std::string text = header;
  for (int i = 0; i < rows; ++i)
    text += std::to_string(7 * i) + row;
  const fs::path out = scratch_directory() / "values.csv";
  ASSERT_EQ(eval(text, {"--backend", "opengl"}, out).code, 0);
  std::istringstream lines(read_text(out));
  std::string line;
  std::getline(lines, line);
  for (int i = 0; i < rows; ++i) {
    ASSERT_TRUE(std::getline(lines, line));
    ASSERT_TRUE(line.starts_with(std::to_string(7 * i) + ",3.5367")) << line;
  }
  EXPECT_FALSE(std::getline(lines, line));
}

TEST(eval, a_bad_row_is_named_by_line_and_nothing_is_written) {
  const fs::path out = scratch_directory() / "values.csv";
  fs::remove(out);
  const Finished finished =
      eval(header + "a" + row + "b,R,ggx,x,1.5,0,0,0,0,1,0,0,1,0,0,1\n", {}, out);
  EXPECT_EQ(finished.code, static_cast<int>(ExitCode::input));
  EXPECT_NE(finished.err.find("line 3: alpha is not a number: 'x'"), std::string::npos)
      << finished.err;
  EXPECT_FALSE(fs::exists(out));
}

TEST(eval, unreadable_and_unwritable_files_have_their_exit_codes) {
  const fs::path nowhere = "/dev/null/values.csv";
  EXPECT_EQ(eval(header + "a" + row, {}, nowhere).code, static_cast<int>(ExitCode::output));
  EXPECT_EQ(
      run_program({"eval", "--in", nowhere, "--output", scratch_directory() / "out.csv"}).code,
      static_cast<int>(ExitCode::input));
  EXPECT_EQ(eval(header, {"--backend", "abacus"}, nowhere).code, static_cast<int>(ExitCode::usage));
}

TEST(figures_command, prints_the_files_that_it_wrote) {
  const fs::path folder = scratch_directory() / "figures";
  const Finished finished = run_program({"figures", "-o", folder});
  ASSERT_EQ(finished.code, 0) << finished.err;
  std::istringstream lines(finished.out);
  int files = 0;
  for (std::string line; std::getline(lines, line); ++files)
    EXPECT_TRUE(fs::exists(line)) << line;
  EXPECT_GE(files, 18);
}

} // namespace
} // namespace gg::test
