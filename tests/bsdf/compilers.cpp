// One text, three compilers: every snippet, flattened, compiles alone as desktop GLSL for OpenGL
// and for Vulkan and as GLSL ES 3.00. (That it compiles as C++ in double and in float, pure ones,
// is proved by building alone_f64.cpp and alone_f32.cpp.)
#include "bsdf/snippets.h"

#include <glslang/Public/ResourceLimits.h>
#include <glslang/Public/ShaderLang.h>
#include <gtest/gtest.h>

namespace gg::snippet_test {
namespace {

class Compiler {
public:
  Compiler() { glslang::InitializeProcess(); }
  ~Compiler() { glslang::FinalizeProcess(); }
};

enum class Target { opengl, vulkan, essl };

std::string prelude(Target target) {
  if (target == Target::essl) return glsl::essl_prelude() + "out vec4 pixel;\n";
  return "#version 450\nlayout(location = 0) out vec4 pixel;\n";
}

// The compiler's complaint, empty if it has none. Warnings count.
std::string complaint(const std::string& snippet, Target target) {
  const std::string text = prelude(target) + snippet + "\nvoid main() { pixel = vec4(0.0); }\n";
  const char* pointer = text.c_str();
  glslang::TShader shader(EShLangFragment);
  shader.setStrings(&pointer, 1);
  if (target == Target::opengl) {
    shader.setEnvInput(glslang::EShSourceGlsl, EShLangFragment, glslang::EShClientOpenGL, 100);
    shader.setEnvClient(glslang::EShClientOpenGL, glslang::EShTargetOpenGL_450);
    shader.setEnvTarget(glslang::EShTargetSpv, glslang::EShTargetSpv_1_0);
  } else if (target == Target::vulkan) {
    shader.setEnvInput(glslang::EShSourceGlsl, EShLangFragment, glslang::EShClientVulkan, 100);
    shader.setEnvClient(glslang::EShClientVulkan, glslang::EShTargetVulkan_1_0);
    shader.setEnvTarget(glslang::EShTargetSpv, glslang::EShTargetSpv_1_0);
  }
  const bool parsed = shader.parse(GetDefaultResources(), 100, false, EShMsgDefault);
  const std::string log = shader.getInfoLog();
  if (!parsed || log.find("WARNING") != std::string::npos) return "(parsed) " + log;
  glslang::TProgram program;
  program.addShader(&shader);
  return program.link(EShMsgDefault) ? "" : std::string("(linked) ") + program.getInfoLog();
}

class Snippet : public testing::TestWithParam<std::filesystem::path> {
protected:
  static Compiler& compiler() {
    static Compiler one;
    return one;
  }
  std::string text() const {
    compiler();
    return glsl::flatten(shaders(), GetParam()).text;
  }
};

TEST_P(Snippet, compiles_as_glsl_for_opengl) {
  EXPECT_EQ(complaint(text(), Target::opengl), "");
}
TEST_P(Snippet, compiles_as_glsl_for_vulkan) {
  EXPECT_EQ(complaint(text(), Target::vulkan), "");
}
TEST_P(Snippet, compiles_as_glsl_es_300) {
  EXPECT_EQ(complaint(text(), Target::essl), "");
}

// Pasted after one another, flattened snippets meet their shared parts twice: the guards make that
// one definition.
TEST_P(Snippet, compiles_when_pasted_twice) {
  EXPECT_EQ(complaint(text() + text(), Target::opengl), "");
}

INSTANTIATE_TEST_SUITE_P(every, Snippet, testing::ValuesIn(snippets()),
                         [](const auto& one) { return test_name(one.param); });

TEST(compilers, notice_what_is_wrong) {
  static Compiler one;
  EXPECT_NE(complaint("float f() { return 1 }", Target::opengl), "");
  EXPECT_NE(complaint("float f() { return 1; }", Target::essl), ""); // no implicit conversion in ES
  EXPECT_EQ(complaint("float f() { return 1.0; }", Target::essl), "");
}

} // namespace
} // namespace gg::snippet_test
