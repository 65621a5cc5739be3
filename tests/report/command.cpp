// groundglass report as a user meets it.
#include "image/image.h"
#include "support/program.h"
#include "support/scratch.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <fstream>
#include <iterator>
#include <map>

namespace gg::test {
namespace {

namespace fs = std::filesystem;

const std::string ball = asset("scenes/shaderball.glb");

std::string contents(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

std::map<std::string, fs::file_time_type> times_of(const fs::path& directory) {
  std::map<std::string, fs::file_time_type> times;
  for (const auto& entry : fs::directory_iterator(directory))
    times[entry.path().filename()] = entry.last_write_time();
  return times;
}

// A report of the smallest useful size.
std::vector<std::string> words(const std::vector<std::string>& more) {
  std::vector<std::string> all{
      "report",   ball,     "-o",        (scratch_directory() / "report").string(),
      "--size",   "64x64",  "--spp",     "8",
      "--frames", "5",      "--samples", "1",
      "--env",    "1,.8,.6"};
  all.insert(all.end(), more.begin(), more.end());
  return all;
}

void expect_refusal(const std::vector<std::string>& more, int code, const std::string& naming) {
  const Finished f = run_program(words(more));
  EXPECT_EQ(f.code, code) << f.err;
  EXPECT_NE(f.err.find(naming), std::string::npos) << f.err;
}

} // namespace

TEST(report_command, writes_a_page_numbers_and_plots_and_a_second_run_does_nothing) {
  const fs::path out = scratch_directory() / "report";
  const auto both = words({"--methods", "standard,lobes1", "--max-error", "100"});
  const Finished first = run_program(both);
  ASSERT_EQ(first.code, 0) << first.err;
  EXPECT_NE(first.out.find("truths traced: 1, pictures drawn: 2, timed: 2"), std::string::npos)
      << first.out;
  EXPECT_NE(first.out.find("the fastest with a relMSE of at most 100"), std::string::npos)
      << first.out;
  for (const char* name : {"report.html", "report.csv", "plots.svg"})
    EXPECT_GT(fs::file_size(out / name), 100u) << name;
  const auto json = nlohmann::json::parse(contents(out / "report.json"));
  const auto& scene = json.at("scenes").at(0);
  EXPECT_EQ(scene.at("truth").at("samples"), 8);
  ASSERT_EQ(scene.at("cells").size(), 2u);
  for (const auto& cell : scene.at("cells")) {
    EXPECT_GT(cell.at("picture_ms").at("median"), 0.0);
    EXPECT_EQ(cell.at("picture_ms").at("pictures"), 5);
    EXPECT_GT(cell.at("device_memory_bytes"), 64 * 64 * 16);
    EXPECT_EQ(cell.at("lookups").at("reflected"), 1);
    EXPECT_EQ(cell.at("lookups").at("refracted"), 0); // a metal
    EXPECT_GT(cell.at("errors").at("objects").at("pixels"), 500);
    EXPECT_GT(cell.at("errors").at("objects").at("relmse"), 0.0);
    EXPECT_FALSE(cell.at("passes").empty());
    EXPECT_NE(cell.at("command").get<std::string>().find("--size 64x64 "), std::string::npos);
  }

  const std::string page = contents(out / "report.html");
  const auto kept = times_of(out / "cache");
  const Finished second = run_program(both);
  ASSERT_EQ(second.code, 0) << second.err;
  EXPECT_NE(second.out.find("truths traced: 0, pictures drawn: 0, timed: 0"), std::string::npos)
      << second.out;
  EXPECT_EQ(contents(out / "report.html"), page);
  EXPECT_EQ(times_of(out / "cache"), kept);

  // What changed is done again, and no more: one picture fewer is a sitting of its own.
  const Finished third = run_program(words({"--methods", "lobes1"}));
  EXPECT_NE(third.out.find("truths traced: 0, pictures drawn: 0, timed: 1"), std::string::npos)
      << third.out;
}

TEST(report_command, has_a_point_for_each_number_of_samples_with_its_own_time_and_error) {
  auto more = words({"--methods", "lobes1"});
  more[11] = "1,4";
  const Finished f = run_program(more);
  ASSERT_EQ(f.code, 0) << f.err;
  EXPECT_NE(f.out.find("pictures drawn: 2, timed: 2"), std::string::npos) << f.out;
  const auto json = nlohmann::json::parse(contents(scratch_directory() / "report" / "report.json"));
  const auto& cells = json.at("scenes").at(0).at("cells");
  ASSERT_EQ(cells.size(), 2u);
  EXPECT_EQ(cells[0].at("samples"), 1);
  EXPECT_EQ(cells[1].at("samples"), 4);
  // Four samples are four frames; half of that leaves room for a busy machine.
  EXPECT_GT(cells[1].at("picture_ms").at("min"),
            2.0 * cells[0].at("picture_ms").at("min").get<double>());
  EXPECT_NE(cells[0].at("errors"), cells[1].at("errors"));
  EXPECT_NE(cells[1].at("command").get<std::string>().find("--samples 4"), std::string::npos);
}

TEST(report_command, goes_on_tracing_where_more_is_asked_for_and_damaged_results_are_made_again) {
  const fs::path cache = scratch_directory() / "report" / "cache";
  ASSERT_EQ(run_program(words({"--methods", "lobes1"})).code, 0);
  auto more = words({"--methods", "lobes1"});
  more[7] = "12";
  const Finished further = run_program(more);
  EXPECT_NE(further.out.find("truths traced: 1, pictures drawn: 0, timed: 0"), std::string::npos)
      << further.out;
  for (const auto& entry : fs::directory_iterator(cache))
    if (entry.path().extension() == ".json") std::ofstream(entry.path()) << "{";
  const Finished mended = run_program(more);
  EXPECT_EQ(mended.code, 0) << mended.err;
  EXPECT_NE(mended.out.find("truths traced: 1, pictures drawn: 0, timed: 1"), std::string::npos)
      << mended.out;
}

TEST(report_command, exits_with_7_if_no_method_meets_the_limit_and_names_the_nearest) {
  const Finished f = run_program(words({"--methods", "lobes1", "--budget", "0.000001"}));
  EXPECT_EQ(f.code, 7) << f.err;
  EXPECT_NE(f.out.find("the nearest is lobes1"), std::string::npos) << f.out;
}

TEST(report_command, names_what_is_wrong_with_its_options) {
  expect_refusal({"--methods", "guess"}, 2, "guess");
  expect_refusal({"--methods", "lobes1,,standard"}, 2, "--methods");
  expect_refusal({"--methods", "lobes1,lobes1"}, 2, "--methods");
  expect_refusal({"--backend", "metal"}, 2, "metal");
  EXPECT_FALSE(fs::exists(scratch_directory() / "report")); // before the truth is traced
  expect_refusal({"--frames", "0"}, 2, "--frames");
  expect_refusal({"--max-error", "0"}, 2, "--max-error");
  expect_refusal({"--budget", "-1"}, 2, "--budget");
  expect_refusal({"--max-error", "nan"}, 2, "--max-error");
  expect_refusal({"--budget", "5", "--max-error", "0.1"}, 2, "--budget");
  expect_refusal({"/no/such/model.glb"}, 3, "/no/such/model.glb");
  auto elsewhere = words({});
  elsewhere[3] = "/proc/no/directory";
  const Finished f = run_program(elsewhere);
  EXPECT_EQ(f.code, 5) << f.err;
  EXPECT_NE(f.err.find("/proc/no/directory"), std::string::npos) << f.err;
}

} // namespace gg::test
