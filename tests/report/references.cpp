// Frames against the truth: small references that were traced once (assets/references).
#include "image/compare.h"
#include "support/program.h"
#include "support/scratch.h"

#include <gtest/gtest.h>

#include <cmath>

namespace gg::test {
namespace {

struct Reference {
  std::string name;               // of the .exr
  std::vector<std::string> scene; // words of `capture`: what make_references gives to `truth`
};

const Reference ball_grid{"ball-grid", {asset("scenes/ball-grid.glb"), "--size", "160x160"}};
const Reference slabs{"slabs-0.2", {asset("scenes/slabs-0.2.glb"), "--size", "160x160"}};
const Reference gold_suzanne{
    "suzanne-gold",
    {asset("scenes/Suzanne/Suzanne.gltf"), "--size", "128x128", "--material", "*=gold,alpha=0.2"}};

// relMSE of a frame over objects, by their numbers from 1 in the order of the file's nodes.
double relmse(const Reference& reference, const std::string& method,
              const std::vector<int>& objects) {
  const std::string picture = scratch_directory() / (reference.name + "-" + method + ".exr");
  std::vector<std::string> words{"capture"};
  words.insert(words.end(), reference.scene.begin(), reference.scene.end());
  words.insert(words.end(), {"-o", picture, "--method", method});
  const Finished f = run_program(words);
  EXPECT_EQ(f.code, 0) << f.err;
  if (f.code != 0) return INFINITY;
  const auto comparison =
      image::compare(image::load_picture(picture),
                     image::load_picture(asset("references/" + reference.name + ".exr")), objects);
  testing::Test::RecordProperty((reference.name + "-" + method).c_str(),
                                std::to_string(comparison.objects->relmse));
  return comparison.objects->relmse;
}

const char* const advice = "if the scene or the truth changed on purpose, "
                           "assets/references/make_references traces it again";

} // namespace

TEST(references, say_how_they_were_made_and_how_noisy_they_are) {
  for (const char* name : {"ball-grid", "slabs-0.2", "shaderball-glass", "suzanne-gold"}) {
    const image::Exr exr = image::read_exr(asset(std::string("references/") + name + ".exr"));
    EXPECT_TRUE(exr.half) << name;
    EXPECT_LE(exr.width, 256) << name;
    for (const char* attribute : {"command", "spp", "meanStandardError", "relativeError"})
      EXPECT_TRUE(exr.attributes.contains(attribute)) << name << " lacks " << attribute;
    EXPECT_LT(std::stod(exr.attributes.at("relativeError")), 0.15) << name;
  }
}

// The bounds below are what was measured when the references were made, and a half more: for drivers
// that filter and round otherwise.

TEST(references, gold_is_as_near_the_truth_as_it_was) {
  EXPECT_LE(relmse(gold_suzanne, "standard", {1}), 1.1) << advice;
  EXPECT_LE(relmse(gold_suzanne, "lobes1", {1}), 1.4) << advice;
}

TEST(references, rough_slabs_are_near_the_truth_and_far_nearer_than_standard_practice) {
  const std::vector<int> rough{3, 4, 5};
  const double standard = relmse(slabs, "standard", rough), two = relmse(slabs, "lobes2", rough);
  EXPECT_LE(relmse(slabs, "lobes1", rough), 0.016) << advice;
  EXPECT_LE(two, 0.009) << advice;
  EXPECT_GE(standard, 4.0 * two);
}

TEST(references, glass_balls_are_as_near_the_truth_as_they_were) {
  const std::vector<int> rough{5, 6, 7, 15, 16, 17}; // clear and amber, alpha .15 and more
  EXPECT_LE(relmse(ball_grid, "lobes2", rough), 0.06) << advice;
}

} // namespace gg::test
