// Making a snippet whole, and C++ of it.
#include "bsdf/snippets.h"
#include "core/error.h"
#include "core/files.h"
#include "glsl/cpp_text.h"

#include <gtest/gtest.h>

#include <fstream>

namespace gg::snippet_test {
namespace {
namespace fs = std::filesystem;

// A folder of shaders for one test, named after it.
class Folder {
public:
  Folder() {
    const auto* info = testing::UnitTest::GetInstance()->current_test_info();
    root_ = fs::path(GROUNDGLASS_OUTPUT_DIR) / "flatten" / info->name();
    fs::remove_all(root_);
    fs::create_directories(root_ / "a");
  }
  void file(const std::string& name, const std::string& text) const {
    std::ofstream(root_ / name) << text;
  }
  const fs::path& root() const { return root_; }

  // What is said when `name` cannot be flattened.
  std::string refusal(const std::string& name) const {
    try {
      glsl::flatten(root_, name);
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ExitCode::input);
      return error.what();
    }
    return "(accepted)";
  }

private:
  fs::path root_;
};

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST(flatten, takes_each_file_once_and_keeps_guards) {
  const Folder f;
  f.file("a/base.glsl", "#ifndef BASE\n#define BASE\nbase\n#endif\n");
  f.file("a/left.glsl", "#include \"a/base.glsl\"\nleft\n");
  f.file("top.glsl", "#include \"a/left.glsl\"\n#include \"a/base.glsl\"\ntop\n");
  const glsl::Flattened whole = glsl::flatten(f.root(), "top.glsl");
  EXPECT_EQ(whole.text, "#ifndef BASE\n#define BASE\nbase\n#endif\nleft\ntop\n");
  EXPECT_EQ(whole.files, (std::vector<fs::path>{"top.glsl", "a/left.glsl", "a/base.glsl"}));
  EXPECT_EQ(glsl::include_guards(whole.text), std::vector<std::string>{"BASE"});
}

TEST(flatten, remembers_where_each_line_came_from) {
  const Folder f;
  f.file("a/base.glsl", "one\ntwo\n");
  f.file("top.glsl", "zero\n#include \"a/base.glsl\"\nthree\r\n");
  const glsl::Flattened whole = glsl::flatten(f.root(), "top.glsl");
  ASSERT_EQ(whole.lines.size(), 4U);
  EXPECT_EQ(whole.lines[2].file, "a/base.glsl");
  EXPECT_EQ(whole.lines[2].line, 2);
  EXPECT_EQ(whole.lines[3].line, 3);
  EXPECT_EQ(whole.text, "zero\none\ntwo\nthree\n");
}

TEST(flatten, names_file_and_line_of_what_it_refuses) {
  const Folder f;
  f.file("missing.glsl", "\n#include \"a/none.glsl\"\n");
  f.file("a/one.glsl", "#include \"a/two.glsl\"\n");
  f.file("a/two.glsl", "\n\n#include \"a/one.glsl\"\n");
  f.file("self.glsl", "#include \"self.glsl\"\n");
  f.file("angle.glsl", "#include <a/one.glsl>\n");
  f.file("outside.glsl", "#include \"../x.glsl\"\n");
  EXPECT_TRUE(contains(f.refusal("missing.glsl"), "missing.glsl:2"));
  EXPECT_TRUE(contains(f.refusal("a/one.glsl"), "a/two.glsl:3"));
  EXPECT_TRUE(contains(f.refusal("self.glsl"), "self.glsl:1"));
  EXPECT_TRUE(contains(f.refusal("angle.glsl"), "angle.glsl:1"));
  EXPECT_TRUE(contains(f.refusal("outside.glsl"), "outside.glsl:1"));
  EXPECT_TRUE(contains(f.refusal("nowhere.glsl"), "nowhere.glsl"));
}

TEST(flatten, finds_every_snippet) {
  const auto all = snippets();
  EXPECT_GE(all.size(), 15U);
  EXPECT_NE(std::ranges::find(all, fs::path("bsdf/ggx.glsl")), all.end());
  EXPECT_TRUE(glsl::list_snippets(shaders(), "no_such_folder").empty());
  EXPECT_TRUE(glsl::is_fetch("environment/stack_fetch.glsl"));
  EXPECT_FALSE(glsl::is_fetch("environment/fetch_stack.glsl"));
}

TEST(cpp_text, spells_floats_literals_and_functions_for_cpp) {
  using glsl::cpp_text;
  using glsl::Literals;
  const std::string text =
      "// float 1.0\n#define N 2.0\nconst float A = 1e-3;\nstruct S {\n  float x;\n};\n"
      "float f(vec3 v) { return 0.5 * v.x + float(3); }\nS g() { S s; s.x = 2.5e+4; return s; }\n";
  EXPECT_EQ(cpp_text(text, Literals::suffixed),
            "// float 1.0\n#define N 2.0\nconst Real A = 1e-3f;\nstruct S {\n  Real x;\n};\n"
            "inline Real f(vec3 v) { return 0.5f * v.x + Real(3); }\ninline S g() { S s; s.x = "
            "2.5e+4f; return s; }\n");
  EXPECT_TRUE(contains(cpp_text(text, Literals::bare), "return 0.5 * v.x"));
  EXPECT_TRUE(contains(cpp_text(text, Literals::wrapped), "Real(2.5e+4)"));
}

TEST(cpp_text, leaves_integers_and_comments_alone) {
  const std::string text = "/* 1.0\n float */ int f(int n) { return n + 12; } // 2.0\n";
  EXPECT_EQ(glsl::cpp_text(text, glsl::Literals::suffixed),
            "/* 1.0\n float */ inline int f(int n) { return n + 12; } // 2.0\n");
}

} // namespace
} // namespace gg::snippet_test
