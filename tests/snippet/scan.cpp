#include "snippet/scan.h"

#include <gtest/gtest.h>

namespace gg::snippet {
namespace {

TEST(scan, tells_functions_prototypes_structs_and_constants) {
  const std::string text = "struct S { float a; };\nconst float PI = 3.0;\nvec4 read(vec3 "
                           "at);\nfloat f(S s, int k) { if (k > 0) { return s.a; } return PI; }\n";
  const auto found = items(text);
  ASSERT_EQ(found.size(), 4U);
  EXPECT_EQ(found[0].kind, Item::Kind::structure);
  EXPECT_EQ(found[0].name, "S");
  EXPECT_EQ(text.substr(found[0].begin, found[0].end - found[0].begin), "struct S { float a; };");
  EXPECT_EQ(found[1].kind, Item::Kind::constant);
  EXPECT_EQ(found[1].name, "PI");
  EXPECT_EQ(found[2].kind, Item::Kind::prototype);
  EXPECT_EQ(found[2].type, "vec4");
  EXPECT_EQ(found[3].kind, Item::Kind::function);
  ASSERT_EQ(found[3].parameters.size(), 2U);
  EXPECT_EQ(found[3].parameters[0].type, "S");
  EXPECT_EQ(found[3].parameters[1].name, "k");
}

TEST(scan, survives_text_that_no_compiler_takes) {
  for (const char* text : {"", "}", ";", "(((", "struct", "const", "/*", "//", "# \\", "float f(",
                           "f()}", "struct;", "{};", "a(,);"})
    EXPECT_NO_THROW(items(text)) << text;
}

} // namespace
} // namespace gg::snippet
