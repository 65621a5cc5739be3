// groundglass snippet, as a user runs it. That what it prints compiles is matrix.py's.
#include "support/program.h"

#include <gtest/gtest.h>

#include <string>
#include <utility>

namespace gg::test {
namespace {

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t n = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
    ++n;
  return n;
}

TEST(snippet, prints_each_file_once) {
  const Finished done = run_program({"snippet", "ggx", "transmission", "half_vector"});
  EXPECT_EQ(done.code, 0) << done.err;
  EXPECT_EQ(count(done.out, "struct Facet {"), 1U);
  EXPECT_EQ(count(done.out, "float ggxD("), 1U);
}

TEST(snippet, is_found_by_a_function_that_it_declares) {
  EXPECT_EQ(run_program({"snippet", "ggxD"}).out, run_program({"snippet", "bsdf/ggx.glsl"}).out);
}

TEST(snippet, prefixes_every_name_in_every_target) {
  for (const char* target : {"glsl", "essl", "hlsl", "msl", "wgsl", "cpp"}) {
    const Finished done =
        run_program({"snippet", "ggx", "--target", target, "--prefix", "my_", "--strip"});
    EXPECT_EQ(done.code, 0) << done.err;
    EXPECT_EQ(count(done.out, "my_ggxD(") == 0, false) << target;
    EXPECT_EQ(count(done.out, " ggxD(") + count(done.out, "(ggxD("), 0U) << target;
    EXPECT_EQ(count(done.out, " Facet "), 0U) << target;
  }
}

TEST(snippet, strips_comments_alone) {
  const std::string stripped = run_program({"snippet", "ggx", "--strip"}).out;
  EXPECT_EQ(count(stripped, "//"), 0U);
  EXPECT_EQ(count(stripped, "\n\n"), 0U);
  EXPECT_EQ(count(stripped, "float ggxD("), 1U);
}

TEST(snippet, explains_signature_ranges_cost_and_source) {
  const std::string text = run_program({"snippet", "--explain", "ggxD"}).out;
  for (const char* part :
       {"float ggxD(Tilt m, float alpha)", "1/sr", "arithmetic", "[Walter07]", "half_vector"})
    EXPECT_EQ(count(text, part) > 0, true) << part;
  EXPECT_EQ(count(text, "ggxSample"), 0U);
}

TEST(snippet, says_what_it_cannot_do) {
  const Finished unknown = run_program({"snippet", "ggxx"});
  EXPECT_EQ(unknown.code, 2);
  EXPECT_NE(unknown.err.find("Did you mean ggx?"), std::string::npos) << unknown.err;
  for (const auto& [typed, meant] : {std::pair{"ggxd", "ggxD"}, std::pair{"GGX", "ggx"}}) {
    const Finished cased = run_program({"snippet", typed});
    EXPECT_NE(cased.err.find("Did you mean " + std::string(meant) + "?"), std::string::npos)
        << cased.err;
  }
  const Finished misspelt = run_program({"snippet", "--explain", "refractTwoPair"});
  EXPECT_NE(misspelt.err.find("Did you mean refractTwoPairs?"), std::string::npos) << misspelt.err;
  const Finished target = run_program({"snippet", "ggx", "--target", "hlsll"});
  EXPECT_EQ(target.code, 2);
  EXPECT_NE(target.err.find("Did you mean hlsl?"), std::string::npos) << target.err;
  EXPECT_EQ(run_program({"snippet", "ggx", "--target", "cg"}).code, 2);
  EXPECT_EQ(run_program({"snippet", "ggx", "--prefix", "1a"}).code, 2);
  EXPECT_EQ(run_program({"snippet"}).code, 2);
  const Finished fetch = run_program({"snippet", "composition_fetch", "--target", "wgsl"});
  EXPECT_EQ(fetch.code, 4);
  EXPECT_NE(fetch.err.find("without _fetch"), std::string::npos) << fetch.err;
}

} // namespace
} // namespace gg::test
