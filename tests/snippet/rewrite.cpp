#include "snippet/rewrite.h"

#include <gtest/gtest.h>

namespace gg::snippet {
namespace {

TEST(prefix, renames_declarations_and_their_uses_and_nothing_else) {
  EXPECT_EQ(
      with_prefix("#define ONE 1\nstruct S { float f; };\nfloat f(S s) { return s.f + g(ONE); }\n",
                  "p_"),
      "#define p_ONE 1\nstruct p_S { float f; };\nfloat p_f(p_S s) { return s.f + g(p_ONE); }\n");
}

TEST(prefix, renames_the_type_of_a_field_and_not_its_name) {
  EXPECT_EQ(with_prefix("struct A { float x; };\nstruct B { A A; };\n", "p_"),
            "struct p_A { float x; };\nstruct p_B { p_A A; };\n");
  EXPECT_EQ(with_prefix("struct A { x: f32, }\nstruct B { a: A, A: A }\n", "p_"),
            "struct p_A { x: f32, }\nstruct p_B { a: p_A, A: p_A }\n");
}

TEST(prefix, leaves_comments_alone) {
  EXPECT_EQ(with_prefix("// f of x\nfloat f();\n", "p_"), "// f of x\nfloat p_f();\n");
}

TEST(guards, go_and_other_conditions_stay) {
  EXPECT_EQ(
      without_guards("#ifndef GG_A\n#define GG_A\n#if X\n#define Y\n#endif\nint a;\n#endif\n"),
      "#if X\n#define Y\n#endif\nint a;\n");
}

} // namespace
} // namespace gg::snippet
