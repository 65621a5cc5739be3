// groundglass compare as a user meets it.
#include "image/image.h"
#include "support/program.h"
#include "support/scratch.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <filesystem>
#include <fstream>

namespace gg::test {
namespace {

namespace fs = std::filesystem;

std::string path(const std::string& name) {
  return scratch_directory() / name;
}

std::string constant(const std::string& name, int width, float value) {
  image::Image image(width, 20, 3);
  std::fill(image.values.begin(), image.values.end(), value);
  image::write(path(name), image);
  return path(name);
}

// As truth writes: 0.5 with the given standard error, and a ball in the left half.
std::string truth(const std::string& name, float standard_error) {
  image::Exr exr{.width = 24, .height = 20, .channels = {}, .attributes = {{"object.1", "Ball"}}};
  for (const char* channel : {"R", "G", "B"}) {
    exr.channels[channel].assign(480, 0.5f);
    exr.channels[std::string("stderr.") + channel].assign(480, standard_error);
  }
  for (int i = 0; i < 480; ++i)
    exr.channels["id"].push_back(i % 24 < 12 ? 1.0f : 0.0f);
  image::write_exr(path(name), exr);
  return path(name);
}

void expect_refusal(const std::vector<std::string>& arguments, int code,
                    const std::vector<std::string>& naming) {
  const Finished f = run_program(arguments);
  EXPECT_EQ(f.code, code) << f.err;
  for (const std::string& part : naming)
    EXPECT_NE(f.err.find(part), std::string::npos) << "says: " << f.err << "\nnot: " << part;
  EXPECT_TRUE(f.out.empty()) << f.out;
}

} // namespace

TEST(compare_command, prints_a_table_and_writes_the_same_numbers) {
  const Finished f =
      run_program({"compare", constant("test.exr", 24, 0.6f), truth("truth.exr", 0.001f), "--json",
                   path("numbers.json"), "--map", path("map.png")});
  ASSERT_EQ(f.code, 0) << f.err;
  for (const char* word :
       {"relMSE", "RMSE", "bias", "p99", "PSNR", "FLIP", "frame", "objects", "relMSE from noise"})
    EXPECT_NE(f.out.find(word), std::string::npos) << word << " in\n" << f.out;
  std::ifstream in(path("numbers.json"));
  const auto json = nlohmann::json::parse(in);
  EXPECT_NEAR(json.at("frame").at("relmse"), 0.01 / 0.26, 1e-6);
  EXPECT_EQ(json.at("frame").at("pixels"), 480);
  EXPECT_EQ(json.at("objects").at("pixels"), 11 * 20); // the twelfth column touches the rest
  EXPECT_EQ(json.at("by_object").at(0).at("name"), "Ball");
  EXPECT_NEAR(json.at("frame").at("noise").at("rmse"), 0.001, 1e-6);
  EXPECT_FALSE(json.at("frame").at("noise").at("dominates"));
  EXPECT_GT(image::read(path("map.png")).height, 20);
}

TEST(compare_command, takes_objects_by_name_and_by_id) {
  const std::string test = constant("test.exr", 24, 0.6f), reference = truth("truth.exr", 0.001f);
  const Finished by_name = run_program({"compare", test, reference, "--objects", "Ball"});
  EXPECT_EQ(by_name.code, 0) << by_name.err;
  EXPECT_EQ(by_name.out, run_program({"compare", test, reference, "--objects", "1"}).out);
}

TEST(compare_command, says_when_the_reference_is_too_noisy_and_when_it_does_not_say) {
  const std::string test = constant("test.exr", 24, 0.501f);
  const Finished noisy = run_program({"compare", test, truth("truth.exr", 0.01f)});
  ASSERT_EQ(noisy.code, 0) << noisy.err;
  EXPECT_NE(noisy.out.find("Noise dominates (frame): it explains 100 %"), std::string::npos)
      << noisy.out;
  const Finished silent = run_program({"compare", test, constant("reference.exr", 24, 0.5f)});
  EXPECT_NE(silent.out.find("does not state its standard error"), std::string::npos) << silent.out;
}

TEST(compare_command, names_the_worst_pixel_where_few_rule_the_error) {
  image::Image test(24, 20, 3);
  std::fill(test.values.begin(), test.values.end(), 0.6f);
  image::write(path("even.exr"), test);
  const std::string t = truth("truth.exr", 0.001f);
  const Finished even = run_program({"compare", path("even.exr"), t});
  EXPECT_EQ(even.out.find("Outliers dominate"), std::string::npos) << even.out;
  for (int c = 0; c < 3; ++c)
    test.at(17, 3, c) = 90.0f; // beside the ball
  image::write(path("uneven.exr"), test);
  const Finished f = run_program({"compare", path("uneven.exr"), t});
  EXPECT_NE(f.out.find("Outliers dominate relMSE (frame)"), std::string::npos) << f.out;
  EXPECT_NE(f.out.find("(17, 3): 90, 90, 90 where the reference has 0.5, 0.5, 0.5"),
            std::string::npos)
      << f.out;
}

TEST(compare_command, an_8_bit_picture_against_radiance_is_remarked_on) {
  const Finished f =
      run_program({"compare", constant("test.png", 24, 0.5f), constant("reference.exr", 24, 0.5f)});
  EXPECT_EQ(f.code, 0);
  EXPECT_NE(f.err.find("test.png"), std::string::npos) << f.err;
  EXPECT_NE(f.err.find("--tonemap none"), std::string::npos) << f.err;
}

TEST(compare_command, equal_pictures_have_an_infinite_psnr_and_null_in_json) {
  const std::string a = constant("a.exr", 24, 0.5f);
  const Finished f = run_program({"compare", a, a, "--json", path("numbers.json")});
  ASSERT_EQ(f.code, 0) << f.err;
  EXPECT_NE(f.out.find("inf"), std::string::npos);
  std::ifstream in(path("numbers.json"));
  EXPECT_TRUE(nlohmann::json::parse(in).at("frame").at("psnr_db").is_null());
}

TEST(compare_command, names_what_is_wrong_and_writes_nothing) {
  const std::string a = constant("a.exr", 24, 0.5f), b = constant("b.exr", 25, 0.5f);
  const std::string t = truth("truth.exr", 0.01f), map = path("map.png"), json = path("n.json");
  expect_refusal({"compare", a}, 2, {"REFERENCE"});
  expect_refusal({"compare", a, b, "--map", map, "--json", json}, 3,
                 {"a.exr", "b.exr", "24 x 20", "25 x 20"});
  expect_refusal({"compare", a, path("missing.exr"), "--json", json}, 3, {"missing.exr"});
  expect_refusal({"compare", a, a, "--map", path("map.jpg")}, 2, {"map.jpg", ".png"});
  expect_refusal({"compare", a, a, "--map", map, "--json", "/dev/null/n.json"}, 5,
                 {"/dev/null/n.json"});
  expect_refusal({"compare", a, a, "--map", "/dev/null/m.png", "--json", json}, 5,
                 {"/dev/null/m.png"});
  expect_refusal({"compare", a, a, "--objects", "1"}, 2, {"a.exr", "channel id"});
  expect_refusal({"compare", a, t, "--objects", "2"}, 2, {"truth.exr", "no object 2"});
  for (const char* id : {"0", "-1", "Cube", "1.5", "99999999999"})
    expect_refusal({"compare", a, t, "--objects", id}, 2, {id});
  expect_refusal({"compare", a, t, "--objects", "Bal"}, 2, {"Did you mean Ball?"});
  image::Image bad = image::read(a);
  bad.at(3, 2, 1) = NAN;
  image::write(path("bad.exr"), bad);
  expect_refusal({"compare", path("bad.exr"), a, "--map", map}, 3,
                 {"bad.exr, pixel (3, 2)", "nan"});
  EXPECT_FALSE(fs::exists(map));
  EXPECT_FALSE(fs::exists(json));
}

} // namespace gg::test
