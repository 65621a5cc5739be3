// `--method auto`: the method that a scene and a limit ask for, as a user meets it.
#include "image/image.h"
#include "support/program.h"
#include "support/scratch.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <map>

namespace gg::test {
namespace {

namespace fs = std::filesystem;

// A small picture of a metal ball, with measurements of its own.
class AutoMethod : public ::testing::Test {
protected:
  static fs::path cache() { return scratch_directory() / "cache"; }
  static std::string out(const char* name) { return scratch_directory() / name; }

  static Finished capture(const std::vector<std::string>& more) {
    std::vector<std::string> words{"capture",   asset("scenes/shaderball.glb"),
                                   "--size",    "32x32",
                                   "--env",     "1,.8,.6",
                                   "--samples", "1"};
    words.insert(words.end(), more.begin(), more.end());
    return run_program(words, {"XDG_CACHE_HOME=" + cache().string()});
  }
  static Finished automatic(const char* option, const char* value, const char* picture) {
    return capture({"--method", "auto", option, value, "-o", out(picture)});
  }
  // The line that says what was chosen, and why.
  static std::string reason(const Finished& f) {
    const auto at = f.err.find("--method auto: ");
    return at == std::string::npos ? "" : f.err.substr(at, f.err.find('\n', at) - at);
  }
  static std::string chosen(const Finished& f) {
    const std::string text = reason(f), before = "--method auto: ";
    return text.empty() ? "" : text.substr(before.size(), text.find(',') - before.size());
  }
};

} // namespace

TEST_F(AutoMethod, draws_what_the_chosen_method_draws_and_measures_once) {
  const Finished first = automatic("--max-error", "1000", "auto.pfm");
  ASSERT_EQ(first.code, 0) << first.err;
  const std::string method = chosen(first);
  ASSERT_FALSE(method.empty()) << first.err;
  ASSERT_EQ(capture({"--method", method, "-o", out("named.pfm")}).code, 0);
  EXPECT_EQ(image::read(out("auto.pfm")).values, image::read(out("named.pfm")).values);

  // The second time nothing is measured: the same times, to the last digit, from the same files.
  const auto files = [] {
    std::map<fs::path, fs::file_time_type> times;
    for (const auto& entry : fs::recursive_directory_iterator(cache() / "groundglass" / "auto"))
      times[entry.path()] = entry.last_write_time();
    return times;
  };
  const auto kept = files();
  EXPECT_GT(kept.size(), 5u);
  const Finished again = automatic("--max-error", "1000", "auto.pfm");
  EXPECT_EQ(reason(again), reason(first));
  EXPECT_EQ(files(), kept);

  // From the same measurements: any time is enough for the most accurate, none for any.
  const Finished patient = automatic("--budget", "1e9", "auto.pfm");
  EXPECT_EQ(patient.code, 0) << patient.err;
  EXPECT_EQ(patient.err.find("no method meets"), std::string::npos) << patient.err;
  const Finished hasty = automatic("--budget", "1e-9", "auto.pfm");
  EXPECT_EQ(hasty.code, 7) << hasty.err;
  EXPECT_NE(hasty.err.find("no method meets the limit, this one comes nearest"), std::string::npos)
      << hasty.err;
  EXPECT_EQ(chosen(hasty), method) << "the fastest of all, as with any error allowed";
  EXPECT_EQ(files(), kept);
}

TEST_F(AutoMethod, wants_one_limit_that_is_a_positive_number_and_nothing_else_does) {
  const std::vector<std::string> refused[] = {
      {"--method", "auto"},
      {"--method", "auto", "--budget", "16", "--max-error", "0.1"},
      {"--method", "auto", "--budget", "0"},
      {"--method", "auto", "--budget", "-3"},
      {"--method", "auto", "--max-error", "nan"},
      {"--method", "auto", "--max-error", "inf"},
      {"--method", "lobes2", "--budget", "16"},
      {"--max-error", "0.1"},
  };
  for (std::vector<std::string> words : refused) {
    const std::string what = words.back();
    words.insert(words.end(), {"-o", out("auto.png")});
    const Finished f = capture(words);
    EXPECT_EQ(f.code, 2) << what << ": " << f.err;
  }
  EXPECT_FALSE(fs::exists(out("auto.png")));
  EXPECT_FALSE(fs::exists(cache()));
}

} // namespace gg::test
