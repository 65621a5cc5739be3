// The dialect of the snippets, as far as a machine can check it, and the block of comments that
// each opens with.
#include "bsdf/snippets.h"
#include "core/files.h"

#include <gtest/gtest.h>

#include <regex>
#include <sstream>

namespace gg::snippet_test {
namespace {

class Dialect : public testing::TestWithParam<std::filesystem::path> {
protected:
  std::string name() const { return GetParam().filename().string(); }
  std::string text() const { return read_text(shaders() / GetParam()); }

  // The text without comments and preprocessor lines.
  std::string code() const {
    std::string all = std::regex_replace(text(), std::regex("/\\*[^]*?\\*/"), " ");
    std::istringstream lines(all);
    std::string out;
    for (std::string line; std::getline(lines, line);) {
      line = line.substr(0, line.find("//"));
      if (line.find_first_not_of(" \t") != std::string::npos
          && line[line.find_first_not_of(" \t")] == '#')
        line.clear();
      out += line + "\n";
    }
    return out;
  }

  void expect_none(const std::string& pattern, const std::string& rule) const {
    const std::string all = code();
    std::smatch match;
    EXPECT_FALSE(std::regex_search(all, match, std::regex(pattern)))
        << rule << ": '" << match.str() << "' in " << GetParam();
  }
};

TEST_P(Dialect, opens_with_the_block_that_says_what_it_is) {
  std::istringstream lines(text());
  std::string line;
  std::getline(lines, line);
  EXPECT_EQ(line.rfind("// " + name() + ": ", 0), 0U) << line;
  const std::string rest = text();
  std::size_t at = 0;
  for (const char* word : {"// Frame    ", "// alpha    ", "// Returns  ", "// Source   ",
                           "// Limits   ", "#ifndef GG_"}) {
    const std::size_t found = rest.find(word, at);
    ASSERT_NE(found, std::string::npos) << "no '" << word << "' line, in this order";
    at = found;
  }
}

TEST_P(Dialect, has_an_include_guard_named_after_itself) {
  std::string expected = "GG_" + test_name(GetParam()) + "_GLSL";
  std::ranges::transform(expected, expected.begin(),
                         [](unsigned char c) { return std::toupper(c); });
  const auto guards = glsl::include_guards(text());
  ASSERT_FALSE(guards.empty());
  EXPECT_EQ(guards.front(), expected);
  EXPECT_TRUE(text().ends_with("\n#endif\n"));
}

TEST_P(Dialect, is_short) {
  std::istringstream lines(text());
  int count = 0;
  for (std::string line; std::getline(lines, line);) {
    ++count;
    // Characters, not bytes: the comments have alpha² and half-brackets in them.
    const auto width = std::ranges::count_if(line, [](char c) { return (c & 0xc0) != 0x80; });
    EXPECT_LE(width, 132) << "line " << count;
  }
  EXPECT_LE(count, 140);
}

TEST_P(Dialect, takes_arguments_and_returns_values) {
  expect_none("\\b(out|inout)\\b", "results are returned, as structs if there are several");
  expect_none("\\b(uniform|varying|attribute|buffer|shared|layout)\\b",
              "snippets take what they need as arguments");
  expect_none("\\b(gl_[A-Za-z]+|discard)\\b", "stages know about stages");
  // At the outermost level only constants, structs and functions: no mutable globals.
  expect_none("\\n(float|int|bool|vec[234]|mat[234]) +\\w+ *(=|;)", "no mutable globals");
}

TEST_P(Dialect, keeps_to_what_all_three_languages_share) {
  expect_none("\\b(highp|mediump|lowp|precision)\\b", "precision comes from the prelude");
  if (!glsl::is_fetch(GetParam())) // which no C++ compiler sees
    expect_none("\\.[xyzw]{2,4}\\b|\\.[rgba]{2,4}\\b|\\.[stpq]{2,4}\\b", "one component at a time");
  expect_none("\\b(float|int|vec[234])\\s*\\[[^\\]]*\\]\\s*\\(", "no array constructors");
  expect_none("\\bdFd[xy]|\\bfwidth\\b", "derivatives belong to stages");
  expect_none("\\b(dvec|dmat|double|half|fma)\\b", "not in GLSL ES 3.00");
  expect_none("[^.\\w]\\.[0-9]|[0-9]\\.[^0-9]", "digits on both sides of a point");
  expect_none("[0-9][fF]\\b", "the literal's precision is the compiler's business");
}

TEST_P(Dialect, fetches_only_in_files_that_say_so) {
  if (glsl::is_fetch(GetParam())) return; // nothing to keep: it may
  expect_none("\\b(sampler\\w*|texture\\w*|texelFetch\\w*|image[123]D\\w*)\\b",
              "only ..._fetch.glsl reads textures");
}

TEST_P(Dialect, names_sources_that_can_be_looked_up) {
  const std::string references = read_text(shaders() / "REFERENCES.md");
  const std::string all = text();
  const std::regex key("\\[([A-Za-z]+[0-9]{2})\\]");
  for (std::sregex_iterator it(all.begin(), all.end(), key), end; it != end; ++it)
    EXPECT_NE(references.find("| " + (*it)[1].str() + " |"), std::string::npos) << (*it)[1];
}

INSTANTIATE_TEST_SUITE_P(every, Dialect, testing::ValuesIn(snippets()),
                         [](const auto& one) { return test_name(one.param); });

} // namespace
} // namespace gg::snippet_test
