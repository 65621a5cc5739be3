// groundglass truth as a user meets it.
#include "core/files.h"
#include "image/image.h"
#include "support/program.h"
#include "support/scratch.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <thread>

namespace gg::test {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> command(const std::vector<std::string>& more) {
  std::vector<std::string> words{
      "truth", asset("scenes/Suzanne/Suzanne.gltf"), "--env", "1,1,1", "--size", "24x16"};
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

std::string out(const char* name) {
  return scratch_directory() / name;
}

// The program at work, to be sent signals; -1 if there can be none.
pid_t start(std::vector<std::string> words) {
  words.insert(words.begin(), GROUNDGLASS_PROGRAM);
  const pid_t child = ::fork();
  if (child != 0) return child;
  std::vector<char*> argv;
  for (std::string& word : words)
    argv.push_back(word.data());
  argv.push_back(nullptr);
  ::execv(GROUNDGLASS_PROGRAM, argv.data());
  ::_exit(127);
}

TEST(truth_command, writes_the_mean_its_error_and_the_objects) {
  ASSERT_EQ(run_program(command({"-o", out("a.exr"), "--spp", "8", "--seed", "5"})).code, 0);
  const image::Exr exr = image::read_exr(out("a.exr"));
  for (const char* channel : {"R", "G", "B", "stderr.R", "stderr.G", "stderr.B", "id", "coverage"})
    EXPECT_TRUE(exr.channels.contains(channel)) << channel;
  EXPECT_EQ(exr.width, 24);
  EXPECT_EQ(exr.height, 16);
  EXPECT_EQ(exr.attributes.at("spp"), "8");
  EXPECT_EQ(exr.attributes.at("seed"), "5");
  EXPECT_TRUE(exr.attributes.contains("meanStandardError"));
  EXPECT_NE(exr.attributes.at("command").find("--spp 8"), std::string::npos);
  EXPECT_EQ(exr.channels.at("id")[24 * 8 + 12], 1.0f);
  EXPECT_EQ(exr.channels.at("R")[0], 1.0f); // the constant sky
  EXPECT_TRUE(fs::is_regular_file(out("a.exr")));
}

TEST(truth_command, writes_pictures_to_look_at) {
  const Finished f =
      run_program(command({"-o", out("b.png"), "--spp", "8", "--json", out("b.json")}));
  ASSERT_EQ(f.code, 0);
  EXPECT_NE(f.out.find("b.png: 24 x 16 pixels, 8 samples per pixel"), std::string::npos) << f.out;
  EXPECT_NE(read_text(out("b.json")).find("\"schema\""), std::string::npos);
  ASSERT_EQ(run_program(command({"-o", out("c.exr"), "-o", out("c.png"), "--spp", "8", "--exposure",
                                 "-1", "--tonemap", "none"}))
                .code,
            0);
  const image::Image plain = image::read(out("b.png")), dark = image::read(out("c.png"));
  EXPECT_EQ(plain.width, 24);
  // The constant sky, 1: half of it, to 8 bits of the display's curve.
  EXPECT_NEAR(dark.at(0, 0, 0), 0.5, 0.01);
  EXPECT_GT(plain.at(0, 0, 0), 0.7);
  EXPECT_EQ(image::read_exr(out("c.exr")).channels.at("R")[0], 1.0f);
}

TEST(truth_command, previews_while_it_works) {
  const std::string file = out("preview.png");
  const pid_t child = start(command({"-o", file, "--spp", "1000000000", "--preview", "0.01"}));
  ASSERT_GE(child, 0);
  for (int tries = 0; tries < 600 && !fs::exists(file); ++tries)
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
  EXPECT_TRUE(fs::exists(file));
  ::kill(child, SIGINT);
  int status = 0;
  EXPECT_EQ(::waitpid(child, &status, 0), child);
}

TEST(truth_command, says_what_clamping_took) {
  const std::string file = out("a.exr");
  const Finished done = run_program(command({"-o", file, "--spp", "8", "--clamp", "0.1"}));
  ASSERT_EQ(done.code, 0);
  EXPECT_NE(done.out.find("clamping took"), std::string::npos) << done.out;
  const image::Exr exr = image::read_exr(file);
  EXPECT_GT(std::stod(exr.attributes.at("clampedShare")), 0.0);
  EXPECT_NE(exr.attributes.at("command").find("--clamp 0.1"), std::string::npos);
  EXPECT_EQ(exr.channels.at("R")[0], 1.0f); // the sky, which nothing scattered
}

TEST(truth_command, resumes_only_what_was_asked_for_in_the_same_way) {
  const std::string file = out("a.exr");
  ASSERT_EQ(run_program(command({"-o", file, "--spp", "4"})).code, 0);
  ASSERT_EQ(run_program(command({"-o", file, "--spp", "12", "--resume"})).code, 0);
  EXPECT_EQ(image::read_exr(file).attributes.at("spp"), "12");
  const Finished other =
      run_program(command({"-o", file, "--spp", "16", "--resume", "--seed", "1"}));
  EXPECT_EQ(other.code, 2);
  EXPECT_NE(other.err.find("seed"), std::string::npos) << other.err;
  const Finished larger =
      run_program(command({"-o", file, "--spp", "16", "--resume", "--fovy", "30"}));
  EXPECT_EQ(larger.code, 2);
  EXPECT_NE(larger.err.find("camera"), std::string::npos) << larger.err;
  const Finished bounced =
      run_program(command({"-o", file, "--spp", "16", "--resume", "--multiscatter"}));
  EXPECT_EQ(bounced.code, 2);
  EXPECT_NE(bounced.err.find("scattering"), std::string::npos) << bounced.err;
  EXPECT_EQ(image::read_exr(file).attributes.at("spp"), "12");
}

// The model's metal is rough: some of its light meets more than one facet.
TEST(truth_command, multiscatter_gives_light_back) {
  const auto mean = [](const std::vector<std::string>& more) {
    std::vector<std::string> words = command({"-o", out("a.exr"), "--spp", "16", "--material",
                                              "*=aluminium,alpha=0.8", "--surface-only"});
    words.insert(words.end(), more.begin(), more.end());
    EXPECT_EQ(run_program(words).code, 0);
    const image::Exr exr = image::read_exr(out("a.exr"));
    double sum = 0.0;
    for (const float v : exr.channels.at("G"))
      sum += static_cast<double>(v);
    return sum / static_cast<double>(exr.channels.at("G").size());
  };
  EXPECT_GT(mean({"--multiscatter"}), 1.01 * mean({}));
}

TEST(truth_command, interrupted_keeps_what_it_has) {
  const std::string file = out("a.exr");
  // The program may not have begun to trace when it is told to stop: then it is given longer.
  for (int seconds = 1; seconds <= 32 && !fs::exists(file); seconds *= 2) {
    const pid_t child = start(command({"-o", file, "--spp", "1000000000"}));
    ASSERT_GE(child, 0);
    std::this_thread::sleep_for(std::chrono::seconds(seconds));
    ::kill(child, SIGINT);
    int status = 0;
    ASSERT_EQ(::waitpid(child, &status, 0), child);
    ASSERT_TRUE(WIFEXITED(status));
    EXPECT_EQ(WEXITSTATUS(status), 130);
  }
  ASSERT_TRUE(fs::exists(file));
  EXPECT_GE(std::stol(image::read_exr(file).attributes.at("spp")), 2);
}

TEST(truth_command, refuses_what_it_cannot_do_before_working) {
  const std::pair<std::vector<std::string>, int> refusals[] = {
      {{"-o", out("a.jpg")}, 2},
      {{"-o", out("a.exr"), "-o", out("b.exr")}, 2},
      {{"-o", out("a.png"), "--resume"}, 2},
      {{"-o", out("a.png"), "--half"}, 2},
      {{"-o", out("a.exr"), "--preview", "1"}, 2},
      {{"-o", out("a.png"), "--preview", "0"}, 2},
      {{"-o", out("a.png"), "--tonemap", "film"}, 2},
      {{"-o", out("a.exr"), "--spp", "1"}, 2},
      {{"-o", out("a.exr"), "--spp", "8", "--error", "0.1"}, 2},
      {{"-o", out("a.exr"), "--spp", "0"}, 2},
      {{"-o", out("a.exr"), "--error", "-1"}, 2},
      {{"-o", out("a.exr"), "--error", "0"}, 2},
      {{"-o", out("a.exr"), "--smith", "jones"}, 2},
      {{"-o", out("a.exr"), "--clamp", "0"}, 2},
  };
  for (const auto& [arguments, code] : refusals)
    EXPECT_EQ(run_program(command(arguments)).code, code) << arguments.back();
  EXPECT_FALSE(fs::exists(out("a.exr")));
}

} // namespace
} // namespace gg::test
